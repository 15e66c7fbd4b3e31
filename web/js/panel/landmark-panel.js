import { announce } from "../page/announce.js";
import { byId } from "../page/dom.js";
import { landmarkLabel, targetName, findVertex } from "../words/names.js";
import { onLocaleChange, isWord, t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").State} State
 * @typedef {import("../viewport/host.js").Tick} Tick
 */

/** Above this number, the panel shows only the count of anchors. */
const NAMED_ANCHORS = 6;

/** Finds a landmark or point by name or number, and moves it in millimetres. */
export class LandmarkPanel {
  #search = byId("landmark-search", HTMLInputElement);
  #help = byId("landmark-help", HTMLParagraphElement);
  /** @type {[Slider, Slider, Slider]} */
  #sliders;
  /** @type {number | undefined} */
  #selected;
  /** @type {import("../words/names.js").Target | undefined} */
  #target;
  /** Last query without a match. @type {string | undefined} */
  #failedQuery;
  #selectable = 0;
  #landmarkIds;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#landmarkIds = host.catalogue.landmarks;
    this.#sliders = [this.#makeSlider("x"), this.#makeSlider("y"), this.#makeSlider("z")];
    byId("landmark-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    // Typing replaces the current name.
    this.#search.addEventListener("focus", () => this.#search.select());
    this.#search.addEventListener("change", () => this.#find(this.#search.value));
    this.#search.addEventListener("input", () => host.read((state) => this.#showHelp(state)));
    this.#search.addEventListener("keydown", ({ key }) => {
      // Repeating a failed query fires no change event.
      const isAgain = this.#search.value.trim() === this.#failedQuery && !this.#isInvalid;
      if (key === "Enter" && isAgain) this.#find(this.#search.value);
    });
    host.onChange((state) => this.#show(state));
    host.onTick((tick) => this.#follow(tick));
    onLocaleChange(() => this.#listNames());
  }

  /** @param {"x" | "y" | "z"} axis */
  #makeSlider(axis) {
    return new Slider({
      label: `landmark.${axis}`,
      longLabel: `landmark.${axis}.long`,
      unit: "mm",
      ...this.#host.catalogue.offset,
      axis,
      onInput: () => this.#preview(),
      onCommit: () => this.#commit(),
      onCancel: () => this.#host.apply("cancel"),
    });
  }

  #preview() {
    const [x, y, z] = this.#sliders;
    this.#host.apply({ offset: [x.value, y.value, z.value] });
  }

  #commit() {
    this.#host.apply("commit");
    const [x = "", y = "", z = ""] = this.#sliders.map((slider) => formatNumber(slider.value, 1));
    announce(t("landmark.moved", { name: this.#selectionName(), x, y, z }));
  }

  /** @param {string} text */
  #find(text) {
    const vertex = findVertex(text, this.#landmarkIds, this.#selectable);
    if (vertex === undefined) return this.#handleNotFound(text.trim());
    this.#host.apply({ "select-at": vertex });
    this.#search.value = this.#selectionName();
    announce(t("landmark.selected", { name: this.#search.value }));
  }

  /** An empty query restores the selection's name. @param {string} text */
  #handleNotFound(text) {
    if (text === "") {
      this.#search.value = this.#selectionName();
      return;
    }
    this.#failedQuery = text;
    this.#showNotFound(text);
    announce(this.#help.textContent ?? "");
  }

  /** @param {string} text */
  #showNotFound(text) {
    this.#search.setAttribute("aria-invalid", "true");
    this.#help.classList.add("field-error");
    this.#help.textContent = t(/^\d+$/.test(text) ? "point.unknown" : "landmark.unknown", { text });
  }

  /** Whether the field reports a failed query. */
  get #isInvalid() {
    return this.#search.hasAttribute("aria-invalid");
  }

  /** Help for the selection, or the reason why it cannot be moved. @param {State} state */
  #showHelp(state) {
    this.#search.removeAttribute("aria-invalid");
    this.#help.classList.toggle("field-error", state.refusal !== undefined);
    this.#help.textContent = t(helpFor(state));
  }

  #selectionName() {
    return this.#target ? targetName(this.#target) : "";
  }

  #listNames() {
    const names = new Set(this.#landmarkIds.map((id, number) => landmarkLabel(id, number)));
    byId("landmark-names", HTMLDataListElement).replaceChildren(...[...names].map((name) => new Option("", name)));
  }

  /** @param {State} state */
  #show(state) {
    byId("landmark-sliders", HTMLFieldSetElement).disabled = state.selected === undefined || state.refusal !== undefined;
    // The error stays until the query or the selection changes.
    const staysInvalid = this.#isInvalid && document.activeElement === this.#search && state.selected === this.#selected;
    if (staysInvalid) this.#showNotFound(this.#failedQuery ?? "");
    else this.#showHelp(state);
    this.#selected = state.selected;
    this.#target = state.target;
    this.#selectable = state.selectable;
    this.#showOffset(state.offsetMm);
    if (!this.#isInvalid) this.#search.value = this.#selectionName();
    this.#showAnchors(state.anchors, state.selected !== undefined);
  }

  /** @param {Tick} tick */
  #follow({ offsetMm }) {
    if (offsetMm) this.#showOffset(offsetMm);
  }

  /** @param {[number, number, number]} offset_mm */
  #showOffset(offset_mm) {
    for (const [axis, slider] of this.#sliders.entries()) slider.value = offset_mm[axis] ?? 0;
  }

  /**
   * @param {number[]} anchors
   * @param {boolean} isSelected whether the list belongs to a selection
   */
  #showAnchors(anchors, isSelected) {
    const list = byId("landmark-anchors", HTMLParagraphElement);
    const named = anchors.length <= NAMED_ANCHORS;
    const text = named ? t("landmark.anchors", { list: anchors.join(", ") }) : t("landmark.anchors.many", { n: anchors.length });
    list.textContent = isSelected && anchors.length > 0 ? text : "";
    list.dataset["anchors"] = anchors.join(" ");
  }
}

/** @param {State} state */
function helpFor(state) {
  if (state.refusal) return /** @type {const} */ (`refusal.${state.refusal}`);
  if (state.liesInPlane) return "landmark.in-plane";
  const key = `selection.${state.chosen["selection"]}.help`;
  return isWord(key) ? key : "selection.landmark.help";
}
