import { announce } from "../page/announce.js";
import { byId, onAction } from "../page/dom.js";
import { idName } from "../words/names.js";
import { t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").Tick} Tick
 * @typedef {import("../../wasm/rosto-studio-web.js").Range} Range
 */

/** Proportion sliders and symmetry. */
export class FacePanel {
  /** By id. @type {Map<string, Slider>} */
  #sliders;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#sliders = new Map(host.catalogue.sliders.map(({ id, range }) => [id, this.#makeSlider(id, range)]));
    byId("face-sliders", HTMLFieldSetElement).append(...[...this.#sliders.values()].map((slider) => slider.element));
    host.onChange(({ slidersMm }) => {
      for (const [id, slider] of this.#sliders) slider.value = slidersMm[id] ?? 0;
    });
    host.onTick((tick) => this.#follow(tick));
    onAction("symmetrise", () => this.#symmetrise());
  }

  /**
   * @param {string} id
   * @param {Range} range in mm
   */
  #makeSlider(id, range) {
    const label = () => idName("slider", id);
    const slider = new Slider({
      label,
      longLabel: () => t("face.slider.long", { name: label() }),
      unit: "mm",
      ...range,
      onInput: () => this.#host.apply({ slide: [id, slider.value] }),
      onCommit: () => {
        this.#host.apply("commit");
        announce(t("face.slid", { name: label(), mm: formatNumber(slider.value, 1) }));
      },
      onCancel: () => this.#host.apply("cancel"),
    });
    slider.element.dataset["slider"] = id;
    return slider;
  }

  #symmetrise() {
    const share = byId("symmetrise-share", HTMLInputElement);
    if (!share.reportValidity()) return;
    this.#host.apply({ symmetrise: share.valueAsNumber / 100 });
    announce(t("symmetrised", { n: share.value }));
  }

  /** @param {Tick} tick */
  #follow({ slider: moved }) {
    const slider = moved && this.#sliders.get(moved[0]);
    if (slider) slider.value = moved[1];
  }
}
