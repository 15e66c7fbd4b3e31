import { announce } from "../page/announce.js";
import { byId, onAction } from "../page/dom.js";
import { idName } from "../words/names.js";
import { t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioTick} StudioTick
 */

const STEP_MM = 0.1;

/** Proportion sliders and symmetry. */
export class FacePanel {
  #sliders;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#sliders = host.answer((studio) => studio.faceSliders).map((slider) => {
      const { id, rangeMm } = slider;
      slider.free();
      return this.#makeSlider(id, rangeMm);
    });
    byId("face-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    host.onTick((tick) => this.#show(tick));
    onAction("symmetrise", () => this.#symmetrise());
  }

  /**
   * @param {string} id
   * @param {number} range_mm
   */
  #makeSlider(id, range_mm) {
    const label = () => idName("slider", id);
    const slider = new Slider({
      label,
      longLabel: () => t("face.slider.long", { name: label() }),
      unit: "mm",
      min: -range_mm,
      max: range_mm,
      step: STEP_MM,
      neutral: 0,
      onInput: () => this.#host.act((studio) => studio.slide(id, slider.value)),
      onCommit: () => {
        this.#host.act((studio) => studio.commit());
        announce(t("face.slid", { name: label(), mm: formatNumber(slider.value, 1) }));
      },
      onCancel: () => this.#host.act((studio) => studio.cancel()),
    });
    slider.element.dataset["slider"] = id;
    return slider;
  }

  #symmetrise() {
    const share = byId("symmetrise-share", HTMLInputElement);
    if (!share.reportValidity()) return;
    this.#host.act((studio) => studio.symmetrise(share.valueAsNumber));
    announce(t("symmetrised", { n: share.value }));
  }

  /** @param {StudioTick} tick */
  #show({ slidersMm }) {
    for (const [place, slider] of this.#sliders.entries()) slider.value = slidersMm[place] ?? 0;
  }
}
