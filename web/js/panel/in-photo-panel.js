import { byId, onAction } from "../page/dom.js";
import { t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/** Selfies are not taken from closer; beyond the maximum, the change is not visible. */
const SEEN_FROM_CM = { min: 20, max: 300, step: 1, neutral: 150 };
/** Show the note if edits are limited by more than this share of the photo's longer side. */
const MIN_LIMIT_SHARE = 0.006;

/**
 * Sets up the edited-photo controls: viewing distance, falloff band and protecting brush.
 *
 * @param {Host} host
 */
export function setUpInPhotoPanel(host) {
  const seenFrom = slider(host, "in-photo-distance", { label: "in-photo.distance", longLabel: "in-photo.distance.long", unit: "cm", ...SEEN_FROM_CM }, (cm) => ({
    "seen-from": cm / 100,
  }));
  const ring = slider(host, "in-photo-falloff-band", { label: "in-photo.ring", longLabel: "in-photo.ring.long", unit: "%", ...inPercent(host.catalogue.falloffBand) }, (share) => ({
    "falloff-band": share / 100,
  }));
  onAction("seen-as-taken", () => host.apply({ "seen-from": undefined }));
  setUpBrush(host);
  setUpDepthNote(host);
  let longerSide_px = 1;
  host.onChange((state) => {
    longerSide_px = Math.max(...(state.photoSizePx ?? [1]));
    ring.value = 100 * state.falloffBand;
    seenFrom.value = Number.isFinite(state.seenFromM) ? 100 * state.seenFromM : SEEN_FROM_CM.max;
    byId("seen-as-taken", HTMLButtonElement).disabled = state.isAsTaken;
  });
  host.onPhoto(() => showLimit(host.ask((studio) => studio.photoLimitedPx) ?? 0, longerSide_px));
}

/**
 * @param {number} limited_px
 * @param {number} longerSide_px of the photo
 */
function showLimit(limited_px, longerSide_px) {
  const line = byId("in-photo-limit", HTMLParagraphElement);
  const text = limited_px > MIN_LIMIT_SHARE * longerSide_px ? t("in-photo.limited", { px: formatNumber(limited_px, 0) }) : "";
  if (line.textContent !== text) line.textContent = text;
}

/** @param {Host} host */
function setUpBrush(host) {
  const box = byId("brush", HTMLInputElement);
  const size = slider(host, "brush-size", { label: "brush.size", longLabel: "brush.size.long", unit: "px", ...host.catalogue.brush }, (px) =>
    box.checked ? { brush: px } : undefined,
  );
  box.addEventListener("change", () => host.apply({ brush: box.checked ? size.value : undefined }));
  onAction("brush-undo", () => host.apply("undo"));
  onAction("brush-redo", () => host.apply("redo"));
  onAction("brush-clear", () => host.apply("clear-strokes"));
  host.onChange(({ brushPx, strokeCount, canRedoStroke }) => {
    box.checked = brushPx !== undefined;
    document.body.toggleAttribute("data-brush", brushPx !== undefined);
    byId("brush-tools", HTMLDivElement).hidden = brushPx === undefined;
    byId("brush-undo", HTMLButtonElement).disabled = strokeCount === 0;
    byId("brush-redo", HTMLButtonElement).disabled = !canRedoStroke;
    byId("brush-clear", HTMLButtonElement).disabled = strokeCount === 0;
  });
}

/** Shows a note with a button to turn the view while the edit points along the view. @param {Host} host */
function setUpDepthNote(host) {
  const note = byId("depth-note", HTMLParagraphElement);
  host.onTick(({ isAlongView }) => (note.hidden = !isAlongView));
  onAction("show-depth", () => host.apply("show-depth"));
}

/**
 * @param {Host} host
 * @param {string} id id of the slider's container
 * @param {Pick<import("./slider.js").SliderOptions, "label" | "longLabel" | "unit" | "min" | "max" | "step" | "neutral">} options
 * @param {(value: number) => import("../viewport/host.js").Intent | undefined} intentOf
 */
function slider(host, id, options, intentOf) {
  /** @type {Slider} */
  const made = new Slider({
    ...options,
    onInput: () => {
      const intent = intentOf(made.value);
      if (intent) host.apply(intent);
    },
    onCommit: () => {},
    onCancel: () => {},
  });
  byId(id, HTMLDivElement).append(made.element);
  return made;
}

/** @param {{ min: number, max: number, step: number, neutral: number }} range */
function inPercent({ min, max, step, neutral }) {
  return { min: 100 * min, max: 100 * max, step: 100 * step, neutral: 100 * neutral };
}
