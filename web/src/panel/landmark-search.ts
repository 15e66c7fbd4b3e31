import { announce } from "../page/announce.ts";
import { byId } from "../page/dom.ts";
import { findVertex, landmarkLabel } from "../words/names.ts";
import { onLocaleChange, t } from "../words/words.ts";
import { textOf } from "./phrase.ts";
import type { Host } from "../viewport/host.ts";
import type { State } from "../../wasm/rosto-studio-web.js";

/** Selects a landmark or point by its name or number. */
export function setUpLandmarkSearch(host: Host) {
  const field = byId("landmark-search", HTMLInputElement);
  const error = byId("landmark-search-error", HTMLParagraphElement);
  const ids = host.catalogue.landmarks;
  /** Last query without a match; empty if the last one had a match. */
  let failed = "";
  let selected: number | undefined;
  const showError = (text: string) => {
    failed = text;
    error.textContent = text && t(/^\d+$/.test(text) ? "point.unknown" : "landmark.unknown", { text });
    error.hidden = text === "";
    field.ariaInvalid = text ? "true" : null;
  };
  const showName = ({ name }: State) => {
    showError("");
    field.value = name ? textOf(name) : "";
  };
  const search = () => {
    const text = field.value.trim();
    const vertex = findVertex(text, ids, host.read(({ selectable }) => selectable) ?? 0);
    if (vertex === undefined && text !== "") {
      showError(text);
      return announce(error.textContent ?? "");
    }
    if (vertex !== undefined) host.apply({ "select-at": vertex });
    host.read(showName);
  };
  // Typing replaces the current name.
  field.addEventListener("focus", () => field.select());
  field.addEventListener("input", () => showError(""));
  field.addEventListener("change", () => field.value.trim() !== failed && search());
  // Repeating a query fires no change event.
  field.addEventListener("keydown", ({ key }) => key === "Enter" && search());
  host.on("change", (state) => {
    // The error stays until the query or the selection changes.
    const stays = failed && document.activeElement === field && state.selected === selected;
    selected = state.selected;
    if (!stays) showName(state);
  });
  onLocaleChange(() => {
    showError(failed);
    const names = new Set(ids.map((id, number) => landmarkLabel(id, number)));
    byId("landmark-names", HTMLDataListElement).replaceChildren(...[...names].map((name) => new Option("", name)));
  });
}
