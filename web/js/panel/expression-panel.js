import { announce } from "../page/announce.js";
import { byId, make, makeIcon, onAction } from "../page/dom.js";
import { idName } from "../words/names.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioState} StudioState
 * @typedef {import("../viewport/host.js").StudioTick} StudioTick
 */

/** Where the face moves, by how ids begin. */
const AREAS = /** @type {const} */ ([
  ["eye", /^eye/],
  ["brow", /^brow/],
  ["jaw", /^jaw/],
  ["mouth", /^mouth/],
  ["cheek", /^(cheek|nose)/],
]);
/** What goes to a side has no partner that could do the same. */
const SIDEWAYS = /^(jaw|mouth)(Left|Right)$/;
const PER_CENT = 100;

/** The expressions, by the parts of the face that they move. */
export class ExpressionPanel {
  #both = byId("expressions-both", HTMLInputElement);
  #ids;
  #sliders;
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#ids = host.answer((studio) => studio.expressionIds);
    this.#sliders = this.#ids.map((id) => this.#makeSlider(id));
    byId("expressions", HTMLDivElement).append(...AREAS.map(([area, begins]) => this.#makeArea(area, begins)));
    this.#both.addEventListener("change", () => host.act((studio) => studio.setMirror(this.#both.checked)));
    onAction("come-to-rest", () => {
      host.act((studio) => studio.comeToRest());
      announce(t("expressions.rested"));
    });
    host.onChange((state) => this.#showSides(state));
    host.onTick((tick) => this.#show(tick));
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
      onInput: () => this.#host.act((studio) => studio.express(id, slider.value / PER_CENT)),
      onCommit: () => {
        this.#host.act((studio) => studio.commit());
        announce(t("expression.shown", { name: label(), n: formatNumber(slider.value, 0) }));
      },
      onCancel: () => this.#host.act((studio) => studio.cancel()),
    });
    slider.element.dataset["expression"] = id;
    return slider;
  }

  /**
   * @param {typeof AREAS[number][0]} area
   * @param {RegExp} begins
   */
  #makeArea(area, begins) {
    const details = make("details", "more");
    const summary = make("summary");
    const title = make("h3");
    const sliders = make("fieldset", "sliders stacked");
    const legend = make("legend", "visually-hidden");
    onLocaleChange(() => (title.textContent = legend.textContent = t(`expressions.${area}`)));
    const own = this.#sliders.filter((_slider, place) => begins.test(this.#ids[place] ?? ""));
    sliders.append(legend, ...own.map((slider) => slider.element));
    summary.append(title, makeIcon("fold"));
    const body = make("div", "more-body");
    body.append(sliders);
    details.append(summary, body);
    details.id = `expressions-${area}`;
    return details;
  }

  /** With both sides together, one slider stands for each pair. @param {StudioState} state */
  #showSides({ mirror }) {
    const was = this.#both.checked;
    this.#both.checked = mirror;
    for (const [place, slider] of this.#sliders.entries()) {
      const id = this.#ids[place] ?? "";
      slider.element.hidden = mirror && id.endsWith("Right") && !SIDEWAYS.test(id);
      if (was !== mirror) slider.name();
    }
  }

  /** @param {StudioTick} tick */
  #show({ weights }) {
    for (const [place, slider] of this.#sliders.entries()) slider.value = (weights[place] ?? 0) * PER_CENT;
  }
}
