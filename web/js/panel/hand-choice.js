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
  byId("hand", HTMLFieldSetElement).addEventListener("change", async ({ target }) => {
    const hand = /** @type {HandName} */ (/** @type {HTMLInputElement} */ (target).value);
    if (hand === "point") await untilWaitIsSaid();
    bench.act((studio) => studio.setHand(hand));
  });
  regions.addEventListener("change", () => {
    const { value } = regions;
    bench.act((studio) => (value === "" ? studio.select() : studio.selectRegion(value)));
    if (value !== "") announce(say("landmark.selected", { name: bench.ask((studio) => studio.selectionName(language())) ?? "" }));
  });
  bench.onChange(({ hand, selectedRegion }) => {
    regions.value = selectedRegion ?? "";
    showFields(hand);
  });
  inEveryLanguage(() => listRegions(bench, regions));
}

/** A dense mesh needs a moment to get its points ready: the words come first. */
export async function untilWaitIsSaid() {
  byId("landmark-help", HTMLParagraphElement).textContent = say("hand.preparing");
  await afterNextFrame();
}

/** @param {HandName} hand */
function showFields(hand) {
  const byRegion = hand === "region";
  const choice = document.querySelector(`input[name='hand'][value='${hand}']`);
  if (choice instanceof HTMLInputElement) choice.checked = true;
  byId("point-field", HTMLDivElement).hidden = hand !== "point";
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
  const named = (bench.ask((studio) => studio.regions(language())) ?? []).map((region) => {
    const option = make("option", undefined, region.label);
    option.value = region.id;
    region.free();
    return option;
  });
  list.replaceChildren(none, ...named);
  list.value = chosen;
}
