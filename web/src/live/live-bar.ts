import { byId, onAction } from "../page/dom.ts";
import { onLocaleChange, t, formatNumber } from "../words/words.ts";
import type { Figures } from "./frame-stats.ts";
import type { WordKey } from "../words/words.ts";

/** Update interval that keeps the figures readable. */
const FIGURES_INTERVAL_MS = 500;

/** The bar over the live preview: status, buttons and optional figures. */
export class LiveBar {
  #bar = byId("live", HTMLElement);
  #status = byId("live-status", HTMLParagraphElement);
  #save = byId("live-save", HTMLButtonElement);
  #toggle = byId("live-figures-shown", HTMLButtonElement);
  #line = byId("live-figures", HTMLParagraphElement);
  #read;
  #timer = 0;
  #word: WordKey | undefined;

  constructor({ save, close, figures }: { save: () => void; close: () => void; figures: () => Figures | undefined; }) {
    this.#read = figures;
    this.#save.addEventListener("click", save);
    onAction("close-live-preview", close);
    this.#toggle.addEventListener("click", () => this.#showFigures(Boolean(this.#line.hidden)));
    onLocaleChange(() => this.#write());
  }

  get isShown() {
    return !this.#bar.hidden;
  }

  show(shown: boolean) {
    this.#bar.hidden = !shown;
    document.body.toggleAttribute("data-live-preview", shown);
    if (shown) byId("live-close", HTMLButtonElement).focus();
    else this.#showFigures(false);
  }

  /** @param word status */
  report(word: WordKey | undefined, canSave: boolean) {
    this.#save.disabled = !canSave;
    if (word === this.#word) return;
    this.#word = word;
    this.#write();
  }

  #showFigures(shown: boolean) {
    this.#line.hidden = !shown;
    this.#toggle.setAttribute("aria-pressed", String(shown));
    clearInterval(this.#timer);
    if (shown) this.#timer = setInterval(() => this.#write(), FIGURES_INTERVAL_MS);
    this.#write();
  }

  #write() {
    this.#status.textContent = this.#word ? t(this.#word) : "";
    const figures = this.#line.hidden ? undefined : this.#read();
    this.#line.textContent = figures ? figuresText(figures) : "";
    Object.assign(this.#line.dataset, figures);
  }
}

function figuresText({ frames, interval_ms, worker_ms, page_ms, age, jitter_px }: Figures) {
  return t("live.figures.line", {
    frames: formatNumber(frames, 0),
    interval: formatNumber(interval_ms, 0),
    worker: formatNumber(worker_ms, 0),
    page: formatNumber(page_ms, 1),
    age,
    jitter: Number.isNaN(jitter_px) ? "–" : formatNumber(jitter_px, 2),
  });
}
