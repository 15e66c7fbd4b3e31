import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import type { Stage } from "../worker/protocol.ts";

const STAGES: Stage[] = ["decode", "detect", "landmarks"];

let phase: "hidden" | "loading" | "working" | "done" = "hidden";

/** Writes the progress title in each locale. */
export function setUpProgress() {
  onLocaleChange(writeTitle);
}

/** Shows that the photo waits for the networks to load. */
export function showLoading() {
  setPhase("loading");
  byId("progress-bar", HTMLProgressElement).removeAttribute("value");
  markSteps(-1);
}

/**
 * Shows the current stage. The bar does not go back within a photo.
 *
 * @param fraction total progress, 0 to 1
 */
export function showStage(stage: Stage, fraction: number) {
  const bar = byId("progress-bar", HTMLProgressElement);
  bar.value = phase === "working" ? Math.max(bar.value, fraction) : fraction;
  setPhase("working");
  markSteps(STAGES.indexOf(stage));
}

export function hideProgress() {
  setPhase("hidden");
}

function setPhase(next: typeof phase) {
  if (phase === next) return;
  phase = next;
  byId("progress", HTMLElement).hidden = next === "hidden";
  writeTitle();
}

function writeTitle() {
  const title = byId("progress-title", HTMLParagraphElement);
  if (phase === "loading") title.textContent = t("progress.loading");
  if (phase === "working") title.textContent = t("progress.working");
}

/** @param now index of the current step */
function markSteps(now: number) {
  for (const item of byId("progress-steps", HTMLOListElement).children) {
    if (!(item instanceof HTMLElement)) continue;
    const step = STAGES.indexOf((item.dataset["step"] as Stage));
    item.dataset["now"] = step < now ? "done" : step === now ? "current" : "later";
    if (step === now) item.setAttribute("aria-current", "step");
    else item.removeAttribute("aria-current");
  }
}
