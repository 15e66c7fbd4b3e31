import { formatTyped, isWord, t } from "../words/words.ts";
import type { Control, Widget } from "../../wasm/rosto-studio-web.js";
import { make, makeIcon } from "../page/dom.ts";
import { domId, labelOf, type Send, type View } from "./widget.ts";

/** Part of the range to each side of the neutral value that leads to it. */
const DETENT = 0.02;

/** Key presses closer together than this form one edit. */
const KEY_COMMIT_DELAY_MS = 700;
const STEP_KEY = /^(Arrow.*|Page.*|Home|End)$/;
const NUMBER = /^[+-]?(\d+[.,]?\d*|[.,]\d+)$/;

type Slider = Extract<Control, { kind: "slider" }>;

/** A range input and a number field for the same value. */
export function makeSlider(id: string, { range: limits, unit, axis }: Slider, send: Send): View<Slider> {
  const { min, max, step, neutral } = limits;
  const [label, range, field] = [make("span", "slider-label"), make("input"), make("input", "number-field")];
  const reset = make("button", "slider-reset", makeIcon("reset"));
  const element = make("div", "slider", label, reset, range, field, make("span", "slider-unit", unit));
  const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  /** Value last shown; the inputs show it rounded. */
  let value = 0;
  /** Value before the typing. */
  let before = 0;
  let isByKey = false;
  /** Timer that commits after the last key press; 0 if none is pending. */
  let pending = 0;

  /** Place of a value on the track, 0 to 1. */
  const share = (number: number) => Math.min(1, Math.max(0, (number - min) / (max - min)));
  const rounded = (number: number) => Number(number.toFixed(decimals)) + 0;
  const isTyping = () => "typing" in field.dataset;
  /** The number in the field; undefined if it is not one, or out of range. */
  const typed = () => {
    const number = parseNumber(field.value, unit);
    // Unchanged: not the rounded number.
    if (number === rounded(value)) return value;
    return number >= min && number <= max ? number : undefined;
  };
  const set = (number: number) => number !== value && send({ set: [id, number] });
  const end = (intent: "commit" | "cancel") => {
    clearTimeout(pending);
    pending = 0;
    send(intent);
  };
  const commitLater = () => {
    clearTimeout(pending);
    pending = setTimeout(() => end("commit"), KEY_COMMIT_DELAY_MS);
  };
  /** Marks a text that is not a number in the range, and names the range. */
  const mark = (isInvalid: boolean) => {
    [field.ariaInvalid, field.title] = isInvalid ? ["true", t("number.range", { min, max })] : [null, ""];
  };
  /** Shows the value in place of the text. */
  const endTyping = () => {
    delete field.dataset["typing"];
    mark(false);
    field.value = formatTyped(rounded(value), decimals);
  };

  element.id = domId(id);
  range.style.setProperty("--neutral", String(share(neutral)));
  if (axis) element.dataset["axis"] = axis;
  Object.assign(range, { type: "range", min, max, step });
  Object.assign(field, { inputMode: "decimal", autocomplete: "off" });
  field.dataset["number"] = "";
  const resetNow = () => {
    set(neutral);
    end("commit");
  };
  reset.type = "button";
  reset.addEventListener("click", resetNow);
  element.addEventListener("dblclick", ({ target }) => target !== field && target !== reset && resetNow());
  range.addEventListener("pointerdown", () => (isByKey = false));
  range.addEventListener("keydown", ({ key }) => (isByKey = STEP_KEY.test(key)));
  range.addEventListener("input", () => {
    // A detent at the neutral value, which keys leave in small steps.
    const isCaught = !isByKey && Math.abs(range.valueAsNumber - neutral) < DETENT * (max - min);
    if (isCaught) range.valueAsNumber = neutral;
    set(range.valueAsNumber);
  });
  range.addEventListener("change", () => (isByKey ? commitLater() : end("commit")));
  field.addEventListener("input", () => {
    if (!isTyping()) {
      if (pending) end("commit");
      before = value;
      // Keys now edit the text: see isTyping in dom.ts.
      field.dataset["typing"] = "";
    }
    const number = typed();
    mark(number === undefined);
    if (number !== undefined) set(number);
  });
  /** Takes the typed number. Browsers leave out "change" if the text was typed before, and replaced meanwhile. */
  const commit = () => {
    const number = typed();
    endTyping();
    set(number ?? before);
    end(number === undefined ? "cancel" : "commit");
  };
  field.addEventListener("change", () => isTyping() && commit());
  field.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && isTyping()) commit();
    const steps = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!steps) return;
    event.preventDefault();
    endTyping();
    set(Math.min(max, Math.max(min, rounded(value) + steps * step)));
    commitLater();
  });
  element.addEventListener("keydown", ({ key }) => {
    if (key !== "Escape") return;
    endTyping();
    end("cancel");
  });
  element.addEventListener("focusout", () => {
    // A field that another face has disabled or hidden loses the focus too.
    if (isTyping() && !field.disabled && field.checkVisibility()) commit();
    endTyping();
    if (pending) end("commit");
  });
  return {
    element,
    show: (widget, { value: next }) => {
      const name = labelOf(widget);
      label.replaceChildren(...(axis ? [make("span", "axis", axis)] : []), name);
      range.ariaLabel = field.ariaLabel = longLabel(widget, name);
      range.disabled = field.disabled = !widget.isEnabled;
      // Another change, such as a new face, ends the typing.
      const stays = isTyping() && rounded(typed() ?? value) === rounded(next);
      value = next;
      range.value = String(rounded(value));
      const [from, to] = [Math.min(value, neutral), Math.max(value, neutral)].map(share);
      for (const [property, of] of [["--from", from], ["--to", to]] as const) range.style.setProperty(property, String(of));
      reset.ariaLabel = reset.title = t("slider.reset", { name });
      reset.hidden = rounded(value) === rounded(neutral) || !widget.isEnabled;
      if (!stays) endTyping();
    },
  };
}

/** Reads a number with a comma or a point, spaces, any minus sign, and the unit; NaN if it is not one. */
function parseNumber(text: string, unit: string) {
  const bare = text.replaceAll(/\s/g, "").replace(/[−–]/, "-");
  const digits = unit !== "" && bare.endsWith(unit) ? bare.slice(0, -unit.length) : bare;
  return NUMBER.test(digits) ? Number(digits.replace(",", ".")) : Number.NaN;
}

/** Accessible name: the label with its unit. */
function longLabel({ id }: Widget, name: string) {
  const key = [`${id}.long`, `${id.split(".")[0]}.long`].find(isWord);
  return key ? t(key, { name }) : name;
}
