import { byId } from "../page/dom.ts";
import { onLocaleChange, t, formatNumber } from "../words/words.ts";
import type { Figures } from "./frame-stats.ts";
import type { WordKey } from "../words/words.ts";

/** Update interval that keeps the figures readable. */
const FIGURES_INTERVAL_MS = 500;

/** Sets up the bar over the live preview: status, buttons and optional figures. */
export function liveBar(save: () => void, read: () => Figures | undefined) {
  const saveButton = byId("live-save", HTMLButtonElement);
  const toggle = byId("live-figures-shown", HTMLButtonElement);
  const line = byId("live-figures", HTMLParagraphElement);
  let timer = 0;
  let status: WordKey | undefined;

  saveButton.addEventListener("click", save);
  toggle.addEventListener("click", () => showFigures(Boolean(line.hidden)));
  onLocaleChange(write);

  function showFigures(shown: boolean) {
    line.hidden = !shown;
    toggle.setAttribute("aria-pressed", String(shown));
    clearInterval(timer);
    if (shown) timer = setInterval(write, FIGURES_INTERVAL_MS);
    write();
  }

  function write() {
    byId("live-status", HTMLParagraphElement).textContent = status ? t(status) : "";
    const figures = line.hidden ? undefined : read();
    line.textContent = figures ? figuresText(figures) : "";
    Object.assign(line.dataset, figures);
  }

  return {
    show: (shown: boolean) => {
      byId("live", HTMLElement).hidden = !shown;
      document.body.toggleAttribute("data-live-preview", shown);
      if (shown) byId("live-close", HTMLButtonElement).focus();
      else showFigures(false);
    },
    report: (word: WordKey | undefined, canSave: boolean) => {
      saveButton.disabled = !canSave;
      if (word === status) return;
      status = word;
      write();
    },
  };
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
