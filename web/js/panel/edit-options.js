import { byId } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../words/words.js").WordKey} WordKey
 * @typedef {import("../../wasm/rosto-studio-web.js").OperatorName} OperatorName
 * @typedef {import("../../wasm/rosto-studio-web.js").HoldName} HoldName
 * @typedef {import("../../wasm/rosto-studio-web.js").DetailsName} DetailsName
 * @typedef {import("../../wasm/rosto-studio-web.js").AnchorsName} AnchorsName
 *
 * @typedef {object} Options
 * @property {OperatorName} operator
 * @property {HoldName} hold
 * @property {DetailsName} details
 * @property {AnchorsName} anchors
 * @property {boolean} mirror
 * @property {boolean} nearby whether the edit reaches no further than the radius
 */

/** @type {Record<"sculpt" | "paper", Options>} */
const PRESETS = {
  sculpt: { operator: "cotangent", hold: "exact", details: "kept", anchors: "oval", mirror: true, nearby: false },
  paper: { operator: "L_s", hold: "soft", details: "kept", anchors: "random", mirror: false, nearby: false },
};

const RADIUS_MM = { min: 5, max: 120, step: 1, usual: 40 };

/** How the surface follows a landmark: a preset, or each choice by itself. */
export class EditOptions {
  #operator = byId("operator", HTMLSelectElement);
  #hold = byId("hold", HTMLSelectElement);
  #details = byId("details", HTMLSelectElement);
  #anchors = byId("anchors", HTMLSelectElement);
  #mirror = byId("mirror", HTMLInputElement);
  #nearby = byId("nearby", HTMLInputElement);
  #pinned = byId("pinned", HTMLInputElement);
  #bench;
  #radius;
  /** @type {(Options & { radius_mm: number | undefined }) | undefined} */
  #applied;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    this.#radius = this.#makeRadius();
    this.#operator.addEventListener("change", () => this.#change());
    this.#hold.addEventListener("change", () => this.#change());
    this.#details.addEventListener("change", () => this.#change());
    this.#anchors.addEventListener("change", () => this.#change());
    this.#mirror.addEventListener("change", () => this.#change());
    this.#nearby.addEventListener("change", () => this.#change());
    this.#pinned.addEventListener("change", () => this.#pin());
    for (const preset of /** @type {const} */ (["sculpt", "paper"])) {
      presetInput(preset).addEventListener("change", () => this.#choose(PRESETS[preset]));
    }
    bench.onChange(({ selected, canMirror }) => {
      this.#showPin(selected);
      this.#mirror.disabled = selected !== undefined && !canMirror;
      byId("mirror-help", HTMLParagraphElement).hidden = !this.#mirror.disabled;
    });
    inEveryLanguage(() => this.#explain());
    this.#choose(PRESETS.sculpt);
  }

  /**
   * Widens or narrows the reach of the edit; returns it in mm.
   *
   * @param {number} factor
   */
  widen(factor) {
    this.#nearby.checked = true;
    this.#radius.value = Math.min(RADIUS_MM.max, Math.max(RADIUS_MM.min, this.#radius.value / factor));
    this.#change();
    return this.#radius.value;
  }

  #makeRadius() {
    const apply = () => this.#change();
    const radius = new Slider({
      label: "edit.radius",
      longLabel: "edit.radius.long",
      unit: "mm",
      ...RADIUS_MM,
      neutral: RADIUS_MM.usual,
      onInput: apply,
      onCommit: apply,
      onCancel: () => {},
    });
    byId("radius", HTMLDivElement).append(radius.element);
    return radius;
  }

  /** @param {Options} options */
  #choose(options) {
    this.#operator.value = options.operator;
    this.#hold.value = options.hold;
    this.#details.value = options.details;
    this.#anchors.value = options.anchors;
    this.#mirror.checked = options.mirror;
    this.#nearby.checked = options.nearby;
    this.#change();
  }

  #change() {
    const now = this.#shown();
    const before = this.#applied;
    this.#applied = now;
    // Each of these solves anew: only what has changed is told.
    this.#bench.act((studio) => {
      if (now.operator !== before?.operator) studio.setOperator(now.operator);
      if (now.hold !== before?.hold) studio.setHold(now.hold);
      if (now.details !== before?.details) studio.setDetails(now.details);
      if (now.anchors !== before?.anchors) studio.setAnchorChoice(now.anchors);
      if (now.mirror !== before?.mirror) studio.setMirror(now.mirror);
      if (now.radius_mm !== before?.radius_mm) studio.setRadius(now.radius_mm);
    });
    byId("radius", HTMLDivElement).hidden = !this.#nearby.checked;
    for (const preset of /** @type {const} */ (["sculpt", "paper"])) {
      presetInput(preset).checked = this.#isPreset(PRESETS[preset]);
    }
    this.#explain();
  }

  #shown() {
    return {
      operator: /** @type {OperatorName} */ (this.#operator.value),
      hold: /** @type {HoldName} */ (this.#hold.value),
      details: /** @type {DetailsName} */ (this.#details.value),
      anchors: /** @type {AnchorsName} */ (this.#anchors.value),
      mirror: this.#mirror.checked,
      nearby: this.#nearby.checked,
      radius_mm: this.#nearby.checked ? this.#radius.value : undefined,
    };
  }

  /** @param {Options} preset */
  #isPreset(preset) {
    const shown = this.#shown();
    return /** @type {(keyof Options)[]} */ (Object.keys(preset)).every((choice) => shown[choice] === preset[choice]);
  }

  #explain() {
    byId("operator-help", HTMLParagraphElement).textContent = say(wordOf(`operator.${this.#operator.value}.help`));
    byId("hold-help", HTMLParagraphElement).textContent = say(wordOf(`hold.${this.#hold.value}.help`));
    byId("details-help", HTMLParagraphElement).textContent = say(wordOf(`details.${this.#details.value}.help`));
    byId("anchors-help", HTMLParagraphElement).textContent = say(wordOf(`anchors.${this.#anchors.value}.help`));
  }

  #pin() {
    this.#bench.act((studio) => studio.setPinned(this.#pinned.checked));
  }

  /** @param {number | undefined} selected */
  #showPin(selected) {
    this.#pinned.disabled = selected === undefined;
    this.#pinned.checked = this.#bench.studio.pinned;
  }
}

/** @param {string} key */
function wordOf(key) {
  return /** @type {WordKey} */ (key);
}

/** @param {"sculpt" | "paper"} preset */
function presetInput(preset) {
  return byId(`preset-${preset}`, HTMLInputElement);
}
