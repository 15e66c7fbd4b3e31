import { announce } from "../page/announce.js";
import { byId, make } from "../page/dom.js";
import { afterNextFrame } from "../page/tasks.js";
import { idName, targetName } from "../words/names.js";
import { onLocaleChange, t } from "../words/words.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 */

/**
 * Sets up the selection mode (landmark, region or point) and the list of regions.
 *
 * @param {Host} host
 */
export function setUpSelectionMode(host) {
  const regions = byId("region", HTMLSelectElement);
  regions.addEventListener("change", () => {
    const { value } = regions;
    host.apply({ select: value === "" ? undefined : { region: value } });
    if (value !== "") announce(t("landmark.selected", { name: host.read(({ target }) => target && targetName(target)) ?? "" }));
  });
  host.onChange(({ target, chosen }) => {
    regions.value = target?.kind === "region" ? target.id : "";
    showFields(chosen["selection"] ?? "");
  });
  onLocaleChange(() => listRegions(host, regions));
}

/**
 * Whether the choice prepares the points of a dense mesh, which takes noticeable time.
 *
 * @param {string} choice
 * @param {string} id
 */
export function isSlow(choice, id) {
  const pointsAreSelected = !byId("point-field", HTMLDivElement).hidden;
  return (choice === "selection" && id === "point") || (choice === "density" && pointsAreSelected);
}

/** Paints the "preparing" message before the work blocks the page. */
export async function announcePreparing() {
  byId("landmark-help", HTMLParagraphElement).textContent = t("selection.preparing");
  await afterNextFrame();
}

/** @param {string} mode */
function showFields(mode) {
  const byRegion = mode === "region";
  byId("point-field", HTMLDivElement).hidden = mode !== "point";
  byId("region-field", HTMLDivElement).hidden = !byRegion;
  byId("landmark-field", HTMLDivElement).hidden = byRegion;
  byId("skip-link", HTMLAnchorElement).href = byRegion ? "#region" : "#landmark-search";
}

/**
 * @param {Host} host
 * @param {HTMLSelectElement} list
 */
function listRegions(host, list) {
  const chosen = list.value;
  const none = make("option", undefined, t("region.none"));
  none.value = "";
  none.hidden = true;
  const named = host.catalogue.regions.map((id) => new Option(idName("region", id), id));
  list.replaceChildren(none, ...named);
  list.value = chosen;
}
