import { byId } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 * @typedef {import("../words/words.js").WordKey} WordKey
 * @typedef {import("../../wasm/rosto-studio-web.js").OperatorName} OperatorName
 * @typedef {import("../../wasm/rosto-studio-web.js").HoldName} HoldName
 * @typedef {import("../../wasm/rosto-studio-web.js").DetailsName} DetailsName
 * @typedef {import("../../wasm/rosto-studio-web.js").AnchorsName} AnchorsName
 */

const PRESETS = /** @type {const} */ (["sculpt", "paper"]);
const EXPLAINED = /** @type {const} */ (["operator", "hold", "details", "anchors"]);

/** How the surface follows a landmark: a preset, or each choice by itself. */
export class EditOptions {
  #mirror = byId("mirror", HTMLInputElement);
  #nearby = byId("nearby", HTMLInputElement);
  #pinned = byId("pinned", HTMLInputElement);
  #bench;
  #radius;

  /** @param {Workbench} bench */
  constructor(bench) {
    this.#bench = bench;
    this.#radius = this.#makeRadius();
    onChoice("operator", (value) => bench.act((studio) => studio.setOperator(/** @type {OperatorName} */ (value))));
    onChoice("hold", (value) => bench.act((studio) => studio.setHold(/** @type {HoldName} */ (value))));
    onChoice("details", (value) => bench.act((studio) => studio.setDetails(/** @type {DetailsName} */ (value))));
    onChoice("anchors", (value) => bench.act((studio) => studio.setAnchorChoice(/** @type {AnchorsName} */ (value))));
    this.#mirror.addEventListener("change", () => bench.act((studio) => studio.setMirror(this.#mirror.checked)));
    this.#nearby.addEventListener("change", () => bench.act((studio) => studio.setNearby(this.#nearby.checked)));
    this.#pinned.addEventListener("change", () => bench.act((studio) => studio.setPinned(this.#pinned.checked)));
    for (const preset of PRESETS) {
      presetInput(preset).addEventListener("change", () => bench.act((studio) => studio.choosePreset(preset)));
    }
    bench.onChange((state) => this.#show(state));
    inEveryLanguage(explain);
  }

  #makeRadius() {
    const apply = () => this.#bench.act((studio) => studio.setRadius(this.#radius.value));
    const { min, max, step, neutral } = this.#bench.studio.radiusRange;
    const radius = new Slider({
      label: "edit.radius",
      longLabel: "edit.radius.long",
      unit: "mm",
      ...{ min, max, step, neutral },
      onInput: apply,
      onCommit: apply,
      onCancel: () => {},
    });
    byId("radius", HTMLDivElement).append(radius.element);
    return radius;
  }

  /** @param {StudioState} state */
  #show({ operator, hold, details, anchorChoice, mirror, nearby, radiusMm, preset, pinned, selected, canMirror }) {
    const chosen = { operator, hold, details, anchors: anchorChoice };
    for (const choice of EXPLAINED) byId(choice, HTMLSelectElement).value = chosen[choice];
    for (const one of PRESETS) presetInput(one).checked = one === preset;
    this.#mirror.checked = mirror;
    this.#mirror.disabled = !canMirror;
    byId("mirror-help", HTMLParagraphElement).hidden = canMirror;
    this.#nearby.checked = nearby;
    byId("radius", HTMLDivElement).hidden = !nearby;
    this.#radius.value = radiusMm;
    this.#pinned.disabled = selected === undefined;
    this.#pinned.checked = pinned;
    explain();
  }
}

/** Says what each choice means. */
function explain() {
  for (const choice of EXPLAINED) {
    const { value } = byId(choice, HTMLSelectElement);
    const key = /** @type {WordKey} */ (`${choice}.${value}.help`);
    byId(`${choice}-help`, HTMLParagraphElement).textContent = say(key);
  }
}

/**
 * @param {string} id of a list to choose from
 * @param {(value: string) => void} choose
 */
function onChoice(id, choose) {
  const list = byId(id, HTMLSelectElement);
  list.addEventListener("change", () => choose(list.value));
}

/** @param {"sculpt" | "paper"} preset */
function presetInput(preset) {
  return byId(`preset-${preset}`, HTMLInputElement);
}
