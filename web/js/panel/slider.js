import { make } from "../page/dom.js";
import { onLocaleChange, t } from "../words/words.js";

/**
 * @typedef {import("../words/words.js").WordKey} WordKey
 * @typedef {WordKey | (() => string)} Label of the page's own words, or asked for in each language
 *
 * @typedef {object} SliderOptions
 * @property {Label} label short, beside the track
 * @property {Label} longLabel said by screen readers, with the unit
 * @property {string} unit written after the number
 * @property {number} min
 * @property {number} max
 * @property {number} step
 * @property {number} neutral where a double click on the label puts it
 * @property {"x" | "y" | "z"} [axis] carries its letter and its colour
 * @property {() => void} onInput while the value moves
 * @property {() => void} onCommit when it is let go
 * @property {() => void} onCancel on Escape
 */

/** Keys pressed one after another within this time make one edit. */
const KEYS_PAUSE_MS = 700;
const STEP_KEYS = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End"]);

/** A slider with its exact number beside it: two controls of one value. */
export class Slider {
  element = make("div", "slider");
  #range = make("input");
  #number = make("input", "number-field");
  /** The commit that follows the last key, while one is waited for. */
  #pending = 0;
  #options;
  #label;

  /** @param {SliderOptions} options */
  constructor(options) {
    this.#options = options;
    if (options.axis) this.element.dataset["axis"] = options.axis;
    const label = make("span", "slider-label");
    label.addEventListener("dblclick", () => this.#reset());
    this.element.append(label, this.#range, this.#number, make("span", "slider-unit", options.unit));
    this.#range.type = "range";
    this.#number.type = "number";
    this.#number.inputMode = "decimal";
    for (const input of [this.#range, this.#number]) this.#wire(input);
    this.value = options.neutral;
    this.#label = label;
    onLocaleChange(() => this.name());
  }

  /** Says its name anew, as in another language or after it has come to stand for something else. */
  name() {
    const { axis, label, longLabel } = this.#options;
    this.#label.replaceChildren();
    if (axis) this.#label.append(make("span", "axis", axis));
    this.#label.append(textOf(label));
    for (const input of [this.#range, this.#number]) input.setAttribute("aria-label", textOf(longLabel));
  }

  /** What is being typed counts as far as the ends; a drag may have gone further. */
  get value() {
    const value = Number(this.#number.value);
    return "typing" in this.#number.dataset ? this.#within(value) : value;
  }

  /** Does not disturb a number that is being typed. */
  set value(value) {
    const rounded = Number(value.toFixed(decimalsOf(this.#options.step)));
    if (this.#range.valueAsNumber !== rounded) this.#range.value = String(rounded);
    if (this.#number.valueAsNumber !== rounded) this.#number.value = String(rounded);
  }

  /** @param {HTMLInputElement} input */
  #wire(input) {
    const { min, max, step, onInput, onCommit, onCancel } = this.#options;
    let byKey = false;
    input.min = String(min);
    input.max = String(max);
    input.step = String(step);
    input.addEventListener("input", () => {
      if (input.type === "number") input.dataset["typing"] = "";
      if (Number.isNaN(input.valueAsNumber)) return;
      if (input.type === "range") this.value = input.valueAsNumber;
      else this.#range.value = String(this.value);
      onInput();
    });
    input.addEventListener("change", () => {
      delete input.dataset["typing"];
      this.value = Number.isNaN(input.valueAsNumber) ? this.#options.neutral : this.#within(input.valueAsNumber);
      onInput();
      if (!byKey) return onCommit();
      clearTimeout(this.#pending);
      this.#pending = setTimeout(() => this.#flush(), KEYS_PAUSE_MS);
    });
    input.addEventListener("pointerdown", () => (byKey = false));
    input.addEventListener("blur", () => this.#flush());
    input.addEventListener("keydown", (event) => {
      byKey = STEP_KEYS.has(event.key);
      if (event.key !== "Escape") return;
      clearTimeout(this.#pending);
      this.#pending = 0;
      onCancel();
    });
  }

  /** @param {number} value */
  #within(value) {
    return Math.min(this.#options.max, Math.max(this.#options.min, value));
  }

  #flush() {
    if (this.#pending === 0) return;
    clearTimeout(this.#pending);
    this.#pending = 0;
    this.#options.onCommit();
  }

  #reset() {
    this.value = this.#options.neutral;
    this.#options.onInput();
    this.#options.onCommit();
  }
}

/** @param {Label} label */
function textOf(label) {
  return typeof label === "function" ? label() : t(label);
}

/** @param {number} step */
function decimalsOf(step) {
  return step < 1 ? Math.round(-Math.log10(step)) : 0;
}
