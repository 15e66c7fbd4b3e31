import { announce } from "../page/announce.js";
import { byId, make, makeIcon, onAction } from "../page/dom.js";
import { idName } from "../words/names.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").State} State
 * @typedef {import("../viewport/host.js").Tick} Tick
 */

/** Facial areas, by prefix of the expression's id. */
const AREAS = /** @type {const} */ ([
  ["eye", /^eye/],
  ["brow", /^brow/],
  ["jaw", /^jaw/],
  ["mouth", /^mouth/],
  ["cheek", /^(cheek|nose)/],
]);
/** Sideways motions of jaw and mouth: left and right are opposites, not a symmetric pair. */
const SIDEWAYS = /^(jaw|mouth)(Left|Right)$/;
const PER_CENT = 100;

/** Expression sliders, grouped by facial area. */
export class ExpressionPanel {
  #both = byId("expressions-both", HTMLInputElement);
  /** By the expression's id. @type {Map<string, Slider>} */
  #sliders;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#sliders = new Map(host.catalogue.expressions.map((id) => [id, this.#makeSlider(id)]));
    byId("expressions", HTMLDivElement).append(...AREAS.map(([area, prefix]) => this.#makeArea(area, prefix)));
    this.#both.addEventListener("change", () => host.apply({ mirror: this.#both.checked }));
    onAction("reset-expressions", () => {
      host.apply("reset-expressions");
      announce(t("expressions.rested"));
    });
    host.onChange((state) => {
      this.#showSides(state);
      for (const [id, slider] of this.#sliders) slider.value = (state.weights[id] ?? 0) * PER_CENT;
    });
    host.onTick((tick) => this.#follow(tick));
  }

  /** @param {string} id */
  #makeSlider(id) {
    const label = () => idName("expression", this.#both.checked && !SIDEWAYS.test(id) ? id.replace(/(Left|Right)$/, "") : id);
    const slider = new Slider({
      label,
      longLabel: () => t("expression.long", { name: label() }),
      unit: "%",
      min: 0,
      max: PER_CENT,
      step: 1,
      neutral: 0,
      onInput: () => this.#host.apply({ express: [id, slider.value / PER_CENT] }),
      onCommit: () => {
        this.#host.apply("commit");
        announce(t("expression.shown", { name: label(), n: formatNumber(slider.value, 0) }));
      },
      onCancel: () => this.#host.apply("cancel"),
    });
    slider.element.dataset["expression"] = id;
    return slider;
  }

  /**
   * @param {typeof AREAS[number][0]} area
   * @param {RegExp} prefix
   */
  #makeArea(area, prefix) {
    const details = make("details", "more");
    const summary = make("summary");
    const title = make("h3");
    const sliders = make("fieldset", "sliders stacked");
    const legend = make("legend", "visually-hidden");
    onLocaleChange(() => (title.textContent = legend.textContent = t(`expressions.${area}`)));
    const areaSliders = [...this.#sliders].filter(([id]) => prefix.test(id));
    sliders.append(legend, ...areaSliders.map(([, slider]) => slider.element));
    summary.append(title, makeIcon("fold"));
    const body = make("div", "more-body");
    body.append(sliders);
    details.append(summary, body);
    details.id = `expressions-${area}`;
    return details;
  }

  /** With symmetry on, one slider controls each pair. @param {State} state */
  #showSides({ mirror }) {
    const was = this.#both.checked;
    this.#both.checked = mirror;
    for (const [id, slider] of this.#sliders) {
      slider.element.hidden = mirror && id.endsWith("Right") && !SIDEWAYS.test(id);
      if (was !== mirror) slider.name();
    }
  }

  /** @param {Tick} tick */
  #follow({ expressions }) {
    for (const [id, weight] of expressions) {
      const slider = this.#sliders.get(id);
      if (slider) slider.value = weight * PER_CENT;
    }
  }
}
