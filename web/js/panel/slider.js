import { make } from "../page/dom.js";
import { onLocaleChange, t } from "../words/words.js";

/**
 * @typedef {import("../words/words.js").WordKey} WordKey
 * @typedef {WordKey | (() => string)} Label key of a text, or a function called for each locale
 *
 * @typedef {object} SliderOptions
 * @property {Label} label short, next to the track
 * @property {Label} longLabel accessible name, including the unit
 * @property {string} unit shown after the number
 * @property {number} min
 * @property {number} max
 * @property {number} step
 * @property {number} neutral value set by a double click on the label
 * @property {"x" | "y" | "z"} [axis] shows the axis letter in its colour
 * @property {() => void} onInput called while the value changes
 * @property {() => void} onCommit called when the change ends
 * @property {() => void} onCancel called on Escape
 */

/** Key presses closer together than this form one edit. */
const KEY_COMMIT_DELAY_MS = 700;
const STEP_KEYS = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End"]);

/** A range input and a number field for the same value. */
export class Slider {
  element = make("div", "slider");
  #range = make("input");
  #number = make("input", "number-field");
  /** Timer that commits after the last key press; 0 if none is pending. */
  #pending = 0;
  #options;
  #label;
  /** Value last set; the fields show it rounded. */
  #exact = 0;

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
    for (const input of [this.#range, this.#number]) this.#listen(input);
    this.value = options.neutral;
    this.#label = label;
    onLocaleChange(() => this.name());
  }

  /** Updates the labels, after a locale change or when the label function's result has changed. */
  name() {
    const { axis, label, longLabel } = this.#options;
    this.#label.replaceChildren();
    if (axis) this.#label.append(make("span", "axis", axis));
    this.#label.append(textOf(label));
    for (const input of [this.#range, this.#number]) input.setAttribute("aria-label", textOf(longLabel));
  }

  /**
   * The exact value if the field shows it, else the entered number. Clamps a number that is being typed; a drag in the
   * 3D view may exceed the range.
   */
  get value() {
    const value = Number(this.#number.value);
    const shown = "typing" in this.#number.dataset ? this.#clamp(value) : value;
    return shown === this.#rounded(this.#exact) ? this.#exact : shown;
  }

  /** Leaves a number field alone whose value already matches, so that typing is not disturbed. */
  set value(value) {
    this.#exact = value;
    const rounded = this.#rounded(value);
    if (this.#range.valueAsNumber !== rounded) this.#range.value = String(rounded);
    if (this.#number.valueAsNumber !== rounded) this.#number.value = String(rounded);
  }

  /** @param {HTMLInputElement} input */
  #listen(input) {
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
      this.value = Number.isNaN(input.valueAsNumber) ? this.#options.neutral : this.#clamp(this.value);
      onInput();
      if (!byKey) return onCommit();
      clearTimeout(this.#pending);
      this.#pending = setTimeout(() => this.#flush(), KEY_COMMIT_DELAY_MS);
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
  #rounded(value) {
    return Number(value.toFixed(decimalsOf(this.#options.step)));
  }

  /** @param {number} value */
  #clamp(value) {
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
