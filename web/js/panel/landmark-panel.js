import { announce } from "../page/announce.js";
import { byId } from "../page/dom.js";
import { shownLandmarkName, announceOnce, vertexCalled } from "../words/names.js";
import { onLocaleChange, isWord, t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioState} StudioState
 * @typedef {import("../viewport/host.js").StudioTick} StudioTick
 */

/** More anchors than this are only counted. */
const NAMED_ANCHORS = 6;
const AXES = /** @type {const} */ (["x", "y", "z"]);

/** Choosing a landmark or a point by name or number, and moving it in millimetres. */
export class LandmarkPanel {
  #search = byId("landmark-search", HTMLInputElement);
  #help = byId("landmark-help", HTMLParagraphElement);
  #sliders;
  #kept_mm = [0, 0, 0];
  #step_mm = 0;
  /** @type {number | undefined} */
  #selected;
  /** What was sought in vain. @type {string | undefined} */
  #missed;
  #selectable = 0;
  #landmarkIds;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#landmarkIds = host.answer((studio) => studio.landmarkIds);
    const { min, max, step, neutral } = host.answer((studio) => studio.offsetRange);
    this.#step_mm = step;
    this.#sliders = AXES.map((axis) => this.#makeSlider(axis, { min, max, step, neutral }));
    byId("landmark-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    // What is typed there is another name.
    this.#search.addEventListener("focus", () => this.#search.select());
    this.#search.addEventListener("change", () => this.#find(this.#search.value));
    this.#search.addEventListener("input", () => host.read((state) => this.#explain(state)));
    this.#search.addEventListener("keydown", ({ key }) => {
      // What was sought in vain and is typed once more is no change.
      const isAgain = this.#search.value.trim() === this.#missed && !this.#isWrong;
      if (key === "Enter" && isAgain) this.#find(this.#search.value);
    });
    host.onChange((state) => this.#show(state));
    host.onTick((tick) => this.#follow(tick));
    onLocaleChange(() => this.#listNames());
  }

  /**
   * @param {"x" | "y" | "z"} axis
   * @param {{ min: number, max: number, step: number, neutral: number }} range
   */
  #makeSlider(axis, range) {
    return new Slider({
      label: `landmark.${axis}`,
      longLabel: `landmark.${axis}.long`,
      unit: "mm",
      ...range,
      axis,
      onInput: () => this.#preview(),
      onCommit: () => this.#commit(),
      onCancel: () => this.#host.act((studio) => studio.cancel()),
    });
  }

  /**
   * The sliders show the sum of the edits of what is selected; a new one adds to what is there. One that only rounds what is
   * there has not been moved.
   */
  #preview() {
    const [dx_mm = 0, dy_mm = 0, dz_mm = 0] = this.#sliders.map((slider, axis) => {
      const by_mm = slider.value - (this.#kept_mm[axis] ?? 0);
      return Math.abs(by_mm) > this.#step_mm / 2 + 1e-9 ? by_mm : 0;
    });
    this.#host.act((studio) => studio.preview(dx_mm, dy_mm, dz_mm));
  }

  #commit() {
    this.#host.act((studio) => studio.commit());
    const [x = "", y = "", z = ""] = this.#sliders.map((slider) => formatNumber(slider.value, 1));
    announce(t("landmark.moved", { name: this.#selectionName(), x, y, z }));
  }

  /** @param {string} text */
  #find(text) {
    const vertex = vertexCalled(text, this.#landmarkIds, this.#selectable);
    if (vertex === undefined) return this.#missing(text.trim());
    this.#host.act((studio) => studio.selectAt(vertex));
    this.#search.value = this.#selectionName();
    announce(t("landmark.selected", { name: this.#search.value }));
  }

  /** Of nothing nothing is sought: the field says again what is selected. @param {string} text */
  #missing(text) {
    if (text === "") {
      this.#search.value = this.#selectionName();
      return;
    }
    this.#missed = text;
    this.#sayMissing(text);
    announce(this.#help.textContent ?? "");
  }

  /** @param {string} text */
  #sayMissing(text) {
    this.#search.setAttribute("aria-invalid", "true");
    this.#help.classList.add("field-error");
    this.#help.textContent = t(/^\d+$/.test(text) ? "point.unknown" : "landmark.unknown", { text });
  }

  /** Whether the field says that what is in it was not found. */
  get #isWrong() {
    return this.#search.hasAttribute("aria-invalid");
  }

  /** What may help, or why what is selected cannot be moved. @param {StudioState} state */
  #explain(state) {
    this.#search.removeAttribute("aria-invalid");
    this.#help.classList.toggle("field-error", state.refusal !== undefined);
    this.#help.textContent = t(helpFor(state));
  }

  #selectionName() {
    return this.#host.ask((studio) => announceOnce(studio.selectedTarget)) ?? "";
  }

  #listNames() {
    const names = new Set(this.#landmarkIds.map((id, number) => shownLandmarkName(id, number)));
    byId("landmark-names", HTMLDataListElement).replaceChildren(...[...names].map((name) => new Option("", name)));
  }

  /** @param {StudioState} state */
  #show(state) {
    byId("landmark-sliders", HTMLFieldSetElement).disabled = state.selected === undefined || state.refusal !== undefined;
    // What is wrong with a name stays said until another is typed or something is selected.
    const staysWrong = this.#isWrong && document.activeElement === this.#search && state.selected === this.#selected;
    if (staysWrong) this.#sayMissing(this.#missed ?? "");
    else this.#explain(state);
    this.#selected = state.selected;
    this.#selectable = state.selectable;
    this.#kept_mm = [state.keptXMm, state.keptYMm, state.keptZMm];
    if (!this.#isWrong) this.#search.value = this.#selectionName();
    this.#showAnchors([...state.anchors], state.selected !== undefined);
  }

  /** @param {StudioTick} tick */
  #follow({ offsetXMm, offsetYMm, offsetZMm }) {
    const moving_mm = [offsetXMm, offsetYMm, offsetZMm];
    for (const [axis, slider] of this.#sliders.entries()) {
      slider.value = (this.#kept_mm[axis] ?? 0) + (moving_mm[axis] ?? 0);
    }
  }

  /**
   * @param {number[]} anchors
   * @param {boolean} isSelected whether they are anchors of anything
   */
  #showAnchors(anchors, isSelected) {
    const list = byId("landmark-anchors", HTMLParagraphElement);
    const named = anchors.length <= NAMED_ANCHORS;
    const text = named ? t("landmark.anchors", { list: anchors.join(", ") }) : t("landmark.anchors.many", { n: anchors.length });
    list.textContent = isSelected && anchors.length > 0 ? text : "";
    list.dataset["anchors"] = anchors.join(" ");
  }
}

/**
 * What may help with what is selected, or with selecting.
 *
 * @param {StudioState} state
 */
function helpFor(state) {
  if (state.refusal) return /** @type {const} */ (`refusal.${state.refusal}`);
  if (state.selectedInPlane) return "landmark.in-plane";
  const key = `selection.${state.chosen("selection")}.help`;
  return isWord(key) ? key : "selection.landmark.help";
}
