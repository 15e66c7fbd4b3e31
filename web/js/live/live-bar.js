import { byId, onAction } from "../page/dom.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";

/** @typedef {import("./figures.js").Figures} Figures */

/** Figures are written so often, so that they can be read. */
const FIGURES_EVERY_MS = 500;

/** What lies over the stage while the mirror is open: a word on what is seen, what can be done, and figures for who wants them. */
export class LiveBar {
  #bar = byId("live", HTMLElement);
  #status = byId("live-status", HTMLParagraphElement);
  #keep = byId("live-keep", HTMLButtonElement);
  #toggle = byId("live-figures-shown", HTMLButtonElement);
  #line = byId("live-figures", HTMLParagraphElement);
  #read;
  #timer = 0;
  /** @type {import("../words/words.js").WordKey | undefined} */
  #word;

  /**
   * @param {{ keep: () => void, close: () => void, figures: () => Figures | undefined }} wishes
   */
  constructor({ keep, close, figures }) {
    this.#read = figures;
    this.#keep.addEventListener("click", keep);
    onAction("close-live-preview", close);
    this.#toggle.addEventListener("click", () => this.#showFigures(Boolean(this.#line.hidden)));
    onLocaleChange(() => this.#write());
  }

  get isShown() {
    return !this.#bar.hidden;
  }

  /** @param {boolean} shown */
  show(shown) {
    this.#bar.hidden = !shown;
    document.body.toggleAttribute("data-live-preview", shown);
    if (shown) byId("live-close", HTMLButtonElement).focus();
    else this.#showFigures(false);
  }

  /**
   * @param {import("../words/words.js").WordKey | undefined} word on what is seen
   * @param {boolean} canKeep
   */
  report(word, canKeep) {
    this.#keep.disabled = !canKeep;
    if (word === this.#word) return;
    this.#word = word;
    this.#write();
  }

  /** @param {boolean} shown */
  #showFigures(shown) {
    this.#line.hidden = !shown;
    this.#toggle.setAttribute("aria-pressed", String(shown));
    clearInterval(this.#timer);
    if (shown) this.#timer = setInterval(() => this.#write(), FIGURES_EVERY_MS);
    this.#write();
  }

  #write() {
    this.#status.textContent = this.#word ? t(this.#word) : "";
    const figures = this.#line.hidden ? undefined : this.#read();
    this.#line.textContent = figures ? wordsOf(figures) : "";
    Object.assign(this.#line.dataset, figures);
  }
}

/** @param {Figures} figures */
function wordsOf({ frames, interval_ms, worker_ms, page_ms, age, jitter_px }) {
  return t("live.figures.line", {
    frames: formatNumber(frames, 0),
    interval: formatNumber(interval_ms, 0),
    worker: formatNumber(worker_ms, 0),
    page: formatNumber(page_ms, 1),
    age,
    jitter: Number.isNaN(jitter_px) ? "–" : formatNumber(jitter_px, 2),
  });
}
