import { announce } from "../page/announce.ts";
import { byId } from "../page/dom.ts";
import type { Host } from "../viewport/host.ts";
import { findVertex, landmarkLabel } from "../words/names.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { textOf } from "./phrase.ts";

/** Selects a landmark or point by its name or number. */
export function setUpLandmarkSearch(host: Host) {
  const field = byId("landmark-search", HTMLInputElement);
  const error = byId("landmark-search-error", HTMLParagraphElement);
  const ids = host.catalogue.landmarks;
  /** Last query without a match. */
  let failed: string | undefined;
  let selected: number | undefined;
  const showName = () => {
    const name = host.read((state) => state.name);
    field.value = name ? textOf(name) : "";
  };
  const showError = (text: string | undefined) => {
    failed = text;
    error.textContent = text === undefined ? "" : t(/^\d+$/.test(text) ? "point.unknown" : "landmark.unknown", { text });
    error.hidden = text === undefined;
    field.ariaInvalid = text === undefined ? null : "true";
  };
  const search = () => {
    const text = field.value.trim();
    const vertex = findVertex(text, ids, host.read(({ selectable }) => selectable) ?? 0);
    if (vertex === undefined && text !== "") {
      showError(text);
      return announce(error.textContent ?? "");
    }
    showError(undefined);
    if (vertex !== undefined) host.apply({ "select-at": vertex });
    showName();
  };
  // Typing replaces the current name.
  field.addEventListener("focus", () => field.select());
  field.addEventListener("change", () => field.value.trim() !== failed && search());
  field.addEventListener("input", () => showError(undefined));
  field.addEventListener("keydown", ({ key }) => {
    // Repeating a query fires no change event.
    if (key === "Enter") search();
  });
  host.onChange((state) => {
    // The error stays until the query or the selection changes.
    const stays = failed !== undefined && document.activeElement === field && state.selected === selected;
    selected = state.selected;
    if (stays) return;
    showError(undefined);
    field.value = state.name ? textOf(state.name) : "";
  });
  onLocaleChange(() => {
    if (failed !== undefined) showError(failed);
    const names = new Set(ids.map((id, number) => landmarkLabel(id, number)));
    byId("landmark-names", HTMLDataListElement).replaceChildren(...[...names].map((name) => new Option("", name)));
  });
}
