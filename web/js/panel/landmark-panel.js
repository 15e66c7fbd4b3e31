import { announce } from "../page/announce.js";
import { byId, make } from "../page/dom.js";
import { inEveryLanguage, language, say, sayNumber } from "../words/words.js";
import { chosenHand } from "./hand-choice.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 */

const LANDMARKS = 468;
const REACH_MM = 40;
const STEP_MM = 0.1;
/** More anchors than this are only counted. */
const NAMED_ANCHORS = 6;
const AXES = /** @type {const} */ (["x", "y", "z"]);

/** Choosing a landmark or a point by name or number, and moving it in millimetres. */
export class LandmarkPanel {
  #search = byId("landmark-search", HTMLInputElement);
  #help = byId("landmark-help", HTMLParagraphElement);
  #sliders = AXES.map((axis) => this.#makeSlider(axis));
  #kept_mm = [0, 0, 0];
  #bench;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    byId("landmark-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    this.#search.addEventListener("change", () => this.#find(this.#search.value));
    bench.onChange((state) => this.#show(state));
    inEveryLanguage(() => this.#listNames());
  }

  /** @param {"x" | "y" | "z"} axis */
  #makeSlider(axis) {
    return new Slider({
      label: `landmark.${axis}`,
      longLabel: `landmark.${axis}.long`,
      unit: "mm",
      min: -REACH_MM,
      max: REACH_MM,
      step: STEP_MM,
      neutral: 0,
      axis,
      onInput: () => this.#preview(),
      onCommit: () => this.#commit(),
      onCancel: () => this.#bench.act((studio) => studio.cancel()),
    });
  }

  /** The sliders show the sum of the edits of what is selected; a new one adds to what is there. */
  #preview() {
    const [dx_mm = 0, dy_mm = 0, dz_mm = 0] = this.#sliders.map((slider, axis) => slider.value - (this.#kept_mm[axis] ?? 0));
    this.#bench.act((studio) => studio.preview(dx_mm, dy_mm, dz_mm));
  }

  #commit() {
    this.#bench.act((studio) => studio.commit());
    const [x = "", y = "", z = ""] = this.#sliders.map((slider) => sayNumber(slider.value, 1));
    announce(say("landmark.moved", { name: this.#bench.studio.selectionName(language()) ?? "", x, y, z }));
  }

  /** @param {string} text */
  #find(text) {
    const vertex = this.#bench.studio.vertexCalled(text, language());
    this.#search.toggleAttribute("aria-invalid", vertex === undefined);
    if (vertex === undefined) {
      this.#help.textContent = say(chosenHand() === "point" ? "point.unknown" : "landmark.unknown", { text });
      announce(this.#help.textContent);
      return;
    }
    this.#bench.act((studio) => studio.takeAt(vertex));
    announce(say("landmark.selected", { name: this.#search.value }));
  }

  #listNames() {
    const options = Array.from({ length: LANDMARKS }, (_, landmark) => {
      const option = make("option");
      option.value = this.#bench.studio.landmarkLabel(landmark, language());
      return option;
    });
    byId("landmark-names", HTMLDataListElement).replaceChildren(...options);
  }

  /** @param {StudioState} state */
  #show(state) {
    byId("landmark-sliders", HTMLFieldSetElement).disabled = state.selected === undefined;
    const help = state.selectedInPlane ? "landmark.in-plane" : /** @type {const} */ (`${chosenHand()}.help`);
    if (document.activeElement !== this.#search) this.#help.textContent = say(help);
    const [alongX] = this.#sliders;
    if (alongX) alongX.disabled = state.selectedInPlane;
    if (state.selected === undefined) return;
    this.#search.value = this.#bench.studio.selectionName(language()) ?? "";
    this.#search.removeAttribute("aria-invalid");
    this.#kept_mm = [state.keptXMm, state.keptYMm, state.keptZMm];
    const moving_mm = [state.offsetXMm, state.offsetYMm, state.offsetZMm];
    for (const [axis, slider] of this.#sliders.entries()) {
      slider.value = (this.#kept_mm[axis] ?? 0) + (moving_mm[axis] ?? 0);
    }
    const anchors = [...this.#bench.studio.anchors()];
    const list = byId("landmark-anchors", HTMLParagraphElement);
    const named = anchors.length <= NAMED_ANCHORS;
    list.textContent = named
      ? say("landmark.anchors", { list: anchors.join(", ") })
      : say("landmark.anchors.many", { n: anchors.length });
    list.dataset["anchors"] = anchors.join(" ");
  }
}
