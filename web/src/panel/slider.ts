import { isWord, t } from "../words/words.ts";
import type { Control, Range, Widget } from "../../wasm/rosto-studio-web.js";
import { make } from "../page/dom.ts";
import { domId, labelOf, type Send } from "./widget.ts";

/** Key presses closer together than this form one edit. */
const KEY_COMMIT_DELAY_MS = 700;
const STEP_KEYS = new Set(["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "PageUp", "PageDown", "Home", "End"]);

type Slider = Extract<Control, { kind: "slider" }>;

/** A range input and a number field for the same value. */
export class SliderView {
  element = make("div", "slider");
  #range = make("input");
  #number = make("input", "number-field");
  #label = make("span", "slider-label");
  #send: Send;
  #id: string;
  #limits: Range;
  /** Value last shown; the fields show it rounded. */
  #value = 0;
  /** Timer that commits after the last key press; 0 if none is pending. */
  #pending = 0;

  constructor(id: string, { range, unit, axis }: Slider, send: Send) {
    [this.#id, this.#send, this.#limits] = [id, send, range];
    this.element.id = domId(id);
    if (axis) this.element.dataset["axis"] = axis;
    Object.assign(this.#range, { type: "range", min: range.min, max: range.max, step: range.step });
    Object.assign(this.#number, { inputMode: "decimal", autocomplete: "off" });
    this.#number.dataset["number"] = "";
    this.#label.addEventListener("dblclick", () => this.#finish(this.#limits.neutral));
    this.element.append(this.#label, this.#range, this.#number, make("span", "slider-unit", unit));
    this.#listenToRange();
    this.#listenToNumber();
    for (const input of [this.#range, this.#number]) {
      input.addEventListener("blur", () => this.#flush());
      input.addEventListener("keydown", ({ key }) => key === "Escape" && this.#cancel());
    }
  }

  /** Whether the number field has a text that is being typed; keys then edit it. */
  get #isTyping() {
    return "typing" in this.#number.dataset;
  }

  set #isTyping(isTyping: boolean) {
    this.#number.toggleAttribute("data-typing", isTyping);
  }

  show(widget: Widget) {
    const { value, axis } = widget.control as Slider;
    const label = labelOf(widget);
    this.#label.replaceChildren(...(axis ? [make("span", "axis", axis)] : []), label);
    for (const input of [this.#range, this.#number]) [input.ariaLabel, input.disabled] = [longLabel(widget, label), !widget.isEnabled];
    // Another change, such as a new face, ends the typing.
    const typed = this.#typed() ?? this.#value;
    this.#isTyping &&= this.#rounded(typed) === this.#rounded(value);
    this.#value = value;
    this.#range.value = String(this.#rounded(value));
    if (!this.#isTyping) this.#endTyping();
  }

  #listenToRange() {
    let byKey = false;
    this.#range.addEventListener("pointerdown", () => (byKey = false));
    this.#range.addEventListener("keydown", ({ key }) => (byKey = STEP_KEYS.has(key)));
    this.#range.addEventListener("input", () => this.#set(this.#range.valueAsNumber));
    this.#range.addEventListener("change", () => (byKey ? this.#finishLater() : this.#send("commit")));
  }

  #listenToNumber() {
    this.#number.addEventListener("input", () => {
      this.#isTyping = true;
      const value = this.#typed();
      this.#mark(value === undefined);
      if (value !== undefined) this.#set(value);
    });
    // The last number replaces an unfinished one.
    this.#number.addEventListener("change", () => {
      const value = this.#typed();
      this.#endTyping();
      this.#finish(value ?? this.#value);
    });
    // A new face takes the focus without a change event.
    this.#number.addEventListener("blur", () => this.#endTyping());
    this.#number.addEventListener("keydown", (event) => {
      const steps = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (!steps) return;
      event.preventDefault();
      const { min, max, step } = this.#limits;
      this.#isTyping = false;
      this.#set(Math.min(max, Math.max(min, this.#rounded(this.#value) + steps * step)));
      this.#finishLater();
    });
  }

  /** The number in the field, with a comma or a point; undefined if it is not one, or out of range. */
  #typed() {
    const text = this.#number.value.trim().replace(",", ".").replace("−", "-");
    const value = Number(text);
    const { min, max } = this.#limits;
    if (text === "" || !(value >= min && value <= max)) return undefined;
    // Unchanged: not the rounded number.
    return value === this.#rounded(this.#value) ? this.#value : value;
  }

  #set(value: number) {
    this.#send({ set: [this.#id, value] });
  }

  #finish(value: number) {
    if (value !== this.#value) this.#set(value);
    this.#send("commit");
  }

  #finishLater() {
    clearTimeout(this.#pending);
    this.#pending = setTimeout(() => this.#flush(), KEY_COMMIT_DELAY_MS);
  }

  #flush() {
    if (this.#pending === 0) return;
    clearTimeout(this.#pending);
    this.#pending = 0;
    this.#send("commit");
  }

  #cancel() {
    clearTimeout(this.#pending);
    this.#pending = 0;
    this.#endTyping();
    this.#send("cancel");
  }

  /** Shows the value in place of the text. */
  #endTyping() {
    this.#isTyping = false;
    this.#mark(false);
    this.#number.value = this.#written(this.#value);
  }

  /** Marks a text that is not a number in the range, and names the range. */
  #mark(isInvalid: boolean) {
    const { min, max } = this.#limits;
    [this.#number.ariaInvalid, this.#number.title] = isInvalid ? ["true", t("number.range", { min, max })] : [null, ""];
  }

  #rounded(value: number) {
    return Number(value.toFixed(this.#decimals));
  }

  get #decimals() {
    return Math.max(0, Math.ceil(-Math.log10(this.#limits.step) - 1e-9));
  }

  /** Without grouping, so that the text can be edited. */
  #written(value: number) {
    const decimals = this.#decimals;
    return new Intl.NumberFormat(document.documentElement.lang, { maximumFractionDigits: decimals, useGrouping: false }).format(this.#rounded(value) + 0);
  }
}

/** Accessible name: the label with its unit. */
function longLabel({ id }: Widget, name: string) {
  const keys = [`${id}.long`, `${id.split(".")[0]}.long`];
  const key = keys.find(isWord);
  return key ? t(key, { name }) : name;
}
