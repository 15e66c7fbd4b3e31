import { announce } from "../page/announce.js";
import { byId, make, makeIcon, onAction } from "../page/dom.js";
import { sayId } from "../words/names.js";
import { inEveryLanguage, say, sayNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 * @typedef {import("../viewport/workbench.js").StudioTick} StudioTick
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
  #bench;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    this.#ids = bench.answer((studio) => studio.expressionIds);
    this.#sliders = this.#ids.map((id) => this.#makeSlider(id));
    byId("expressions", HTMLDivElement).append(...AREAS.map(([area, begins]) => this.#makeArea(area, begins)));
    this.#both.addEventListener("change", () => bench.act((studio) => studio.setMirror(this.#both.checked)));
    onAction("come-to-rest", () => {
      bench.act((studio) => studio.comeToRest());
      announce(say("expressions.rested"));
    });
    bench.onChange((state) => this.#showSides(state));
    bench.onTick((tick) => this.#show(tick));
  }

  /** @param {string} id */
  #makeSlider(id) {
    const label = () => sayId("expression", this.#both.checked && !SIDEWAYS.test(id) ? id.replace(/(Left|Right)$/, "") : id);
    const slider = new Slider({
      label,
      longLabel: () => say("expression.long", { name: label() }),
      unit: "%",
      min: 0,
      max: PER_CENT,
      step: 1,
      neutral: 0,
      onInput: () => this.#bench.act((studio) => studio.express(id, slider.value / PER_CENT)),
      onCommit: () => {
        this.#bench.act((studio) => studio.commit());
        announce(say("expression.shown", { name: label(), n: sayNumber(slider.value, 0) }));
      },
      onCancel: () => this.#bench.act((studio) => studio.cancel()),
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
    inEveryLanguage(() => (title.textContent = legend.textContent = say(`expressions.${area}`)));
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
