import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import type { Stage } from "../worker/protocol.ts";

const STAGES: Stage[] = ["decode", "detect", "landmarks"];

let phase: "loading" | "working" | undefined;

/** Writes the progress title in each locale. */
export function setUpProgress() {
  onLocaleChange(() => setPhase(phase));
}

/**
 * Shows the current stage, or that the photo waits for the networks. The bar does not go back within a photo.
 *
 * @param fraction total progress, 0 to 1
 */
export function showProgress(stage: Stage | "loading", fraction: number) {
  const bar = byId("progress-bar", HTMLProgressElement);
  if (stage === "loading") bar.removeAttribute("value");
  else bar.value = phase === "working" ? Math.max(bar.value, fraction) : fraction;
  setPhase(stage === "loading" ? "loading" : "working");
  for (const item of byId("progress-steps", HTMLOListElement).querySelectorAll("li")) {
    const lead = STAGES.indexOf(stage as Stage) - STAGES.indexOf(item.dataset["step"] as Stage);
    item.dataset["now"] = lead > 0 ? "done" : lead === 0 ? "current" : "later";
    item.ariaCurrent = lead === 0 ? "step" : null;
  }
}

export function hideProgress() {
  setPhase(undefined);
}

function setPhase(next: typeof phase) {
  phase = next;
  byId("progress", HTMLElement).hidden = !next;
  if (next) byId("progress-title", HTMLParagraphElement).textContent = t(`progress.${next}`);
}
