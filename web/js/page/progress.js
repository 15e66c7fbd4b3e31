import { onLocaleChange, t } from "../words/words.js";
import { byId } from "./dom.js";

/** @typedef {import("../worker/protocol.js").Stage} Stage */

/** @type {Stage[]} */
const STAGES = ["decode", "detect", "landmarks"];

/** @type {"hidden" | "loading" | "working" | "done"} */
let phase = "hidden";

/** Writes the progress in the page's language. */
export function setUpProgress() {
  onLocaleChange(writeTitle);
}

/** Shows that the photo waits for the worker, whose networks are still on their way. */
export function showLoading() {
  setPhase("loading");
  byId("progress-bar", HTMLProgressElement).removeAttribute("value");
  markSteps(-1);
}

/**
 * Shows how far the photo has come. Within a photo the bar never goes back.
 *
 * @param {Stage} stage at work now
 * @param {number} fraction how much of the whole is done, 0 to 1
 */
export function showStage(stage, fraction) {
  const bar = byId("progress-bar", HTMLProgressElement);
  bar.value = phase === "working" ? Math.max(bar.value, fraction) : fraction;
  setPhase("working");
  markSteps(STAGES.indexOf(stage));
}

/** Takes the progress away. */
export function hideProgress() {
  setPhase("hidden");
}

/** @param {typeof phase} next */
function setPhase(next) {
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

/** @param {number} now index of the step at work */
function markSteps(now) {
  for (const item of byId("progress-steps", HTMLOListElement).children) {
    if (!(item instanceof HTMLElement)) continue;
    const step = STAGES.indexOf(/** @type {Stage} */ (item.dataset["step"]));
    item.dataset["now"] = step < now ? "done" : step === now ? "current" : "later";
    if (step === now) item.setAttribute("aria-current", "step");
    else item.removeAttribute("aria-current");
  }
}
