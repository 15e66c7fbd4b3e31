import { announce } from "../page/announce.js";
import { byId, onAction } from "../page/dom.js";
import { inEveryLanguage, language, say, sayNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioTick} StudioTick
 * @typedef {{ id: string, label: string, rangeMm: number }} Named
 */

const STEP_MM = 0.1;

/** The ready-made sliders, and symmetry. */
export class FacePanel {
  /** @type {Named[]} in the page's language */
  #named = [];
  #sliders;
  #bench;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    inEveryLanguage(() => (this.#named = namesOf(bench)));
    this.#sliders = this.#named.map(({ id, rangeMm }, place) => this.#makeSlider(id, rangeMm, place));
    byId("face-sliders", HTMLFieldSetElement).append(...this.#sliders.map((slider) => slider.element));
    bench.onTick((tick) => this.#show(tick));
    onAction("symmetrise", () => this.#symmetrise());
  }

  /**
   * @param {string} id
   * @param {number} range_mm
   * @param {number} place among the sliders
   */
  #makeSlider(id, range_mm, place) {
    const label = () => this.#named[place]?.label ?? "";
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

/**
 * @param {Workbench} bench
 * @returns {Named[]}
 */
function namesOf(bench) {
  const named = bench.ask((studio) => studio.faceSliders(language())) ?? [];
  return named.map((slider) => {
    const { id, label, rangeMm } = slider;
    slider.free();
    return { id, label, rangeMm };
  });
}
