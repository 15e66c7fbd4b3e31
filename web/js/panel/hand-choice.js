import { announce } from "../page/announce.js";
import { byId, make } from "../page/dom.js";
import { afterNextFrame } from "../page/tasks.js";
import { inEveryLanguage, language, say } from "../words/words.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../../wasm/rosto-studio-web.js").HandName} HandName
 */

/**
 * Whether a click takes one landmark, the region around it or any point of the mesh, and the regions by name.
 *
 * @param {Workbench} bench
 */
export function setUpHandChoice(bench) {
  const regions = byId("region", HTMLSelectElement);
  byId("hand", HTMLFieldSetElement).addEventListener("change", async () => {
    showFields();
    await untilWaitIsSaid();
    bench.act((studio) => studio.setHand(chosenHand()));
  });
  regions.addEventListener("change", () => {
    bench.act((studio) => studio.selectRegion(regions.value));
    announce(say("landmark.selected", { name: bench.studio.selectionName(language()) ?? "" }));
  });
  bench.onChange(({ selectedRegion }) => (regions.value = selectedRegion ?? ""));
  inEveryLanguage(() => listRegions(bench, regions));
}

/** What a click takes: one landmark, the region around it, or any point. */
export function chosenHand() {
  const chosen = document.querySelector("input[name='hand']:checked");
  return /** @type {HandName} */ (chosen instanceof HTMLInputElement ? chosen.value : "landmark");
}

/** Where any point can be taken, a dense mesh needs a moment to get ready: the words come first. */
export async function untilWaitIsSaid() {
  if (chosenHand() !== "point") return;
  byId("landmark-help", HTMLParagraphElement).textContent = say("hand.preparing");
  await afterNextFrame();
}

function showFields() {
  const byRegion = chosenHand() === "region";
  byId("point-field", HTMLDivElement).hidden = chosenHand() !== "point";
  byId("region-field", HTMLDivElement).hidden = !byRegion;
  byId("landmark-field", HTMLDivElement).hidden = byRegion;
  byId("skip-link", HTMLAnchorElement).href = byRegion ? "#region" : "#landmark-search";
}

/**
 * @param {Workbench} bench
 * @param {HTMLSelectElement} list
 */
function listRegions(bench, list) {
  const chosen = list.value;
  const none = make("option", undefined, say("region.none"));
  none.value = "";
  none.hidden = true;
  const named = bench.studio.regions(language()).map(({ id, label }) => {
    const option = make("option", undefined, label);
    option.value = id;
    return option;
  });
  list.replaceChildren(none, ...named);
  list.value = chosen;
}
