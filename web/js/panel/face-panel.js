import { announce } from "../page/announce.js";
import { byId, onAction } from "../page/dom.js";
import { sayId } from "../words/names.js";
import { say, sayNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioTick} StudioTick
 */

const STEP_MM = 0.1;

/** The ready-made sliders, and symmetry. */
export class FacePanel {
  #sliders;
  #bench;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    this.#sliders = bench.answer((studio) => studio.faceSliders).map((slider) => {
      const { id, rangeMm } = slider;
      slider.free();
      return this.#makeSlider(id, rangeMm);
    });
    byId("face-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    bench.onTick((tick) => this.#show(tick));
    onAction("symmetrise", () => this.#symmetrise());
  }

  /**
   * @param {string} id
   * @param {number} range_mm
   */
  #makeSlider(id, range_mm) {
    const label = () => sayId("slider", id);
    const slider = new Slider({
      label,
      longLabel: () => say("face.slider.long", { name: label() }),
      unit: "mm",
      min: -range_mm,
      max: range_mm,
      step: STEP_MM,
      neutral: 0,
      onInput: () => this.#bench.act((studio) => studio.slide(id, slider.value)),
      onCommit: () => {
        this.#bench.act((studio) => studio.commit());
        announce(say("face.slid", { name: label(), mm: sayNumber(slider.value, 1) }));
      },
      onCancel: () => this.#bench.act((studio) => studio.cancel()),
    });
    slider.element.dataset["slider"] = id;
    return slider;
  }

  #symmetrise() {
    const share = byId("symmetrise-share", HTMLInputElement);
    if (!share.reportValidity()) return;
    this.#bench.act((studio) => studio.symmetrise(share.valueAsNumber));
    announce(say("symmetrised", { n: share.value }));
  }

  /** @param {StudioTick} tick */
  #show({ slidersMm }) {
    for (const [place, slider] of this.#sliders.entries()) slider.value = slidersMm[place] ?? 0;
  }
}
