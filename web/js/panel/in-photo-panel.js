import { byId, onAction } from "../page/dom.js";
import { t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioState} StudioState
 */

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
  const seenFrom = slider(host, "in-photo-distance", { label: "in-photo.distance", longLabel: "in-photo.distance.long", unit: "cm", ...SEEN_FROM_CM }, (studio, cm) =>
    studio.setSeenFrom(cm / 100),
  );
  const { min, max, step, neutral } = host.answer((studio) => studio.falloffBandRange);
  const ring = slider(host, "in-photo-falloff-band", { label: "in-photo.ring", longLabel: "in-photo.ring.long", unit: "%", ...inPercent({ min, max, step, neutral }) }, (studio, share) =>
    studio.setFalloffBand(share / 100),
  );
  onAction("seen-as-taken", () => host.act((studio) => studio.setSeenFrom()));
  setUpBrush(host);
  setUpDepthNote(host);
  host.onChange((state) => {
    ring.value = 100 * state.falloffBand;
    seenFrom.value = Number.isFinite(state.seenFromM) ? 100 * state.seenFromM : SEEN_FROM_CM.max;
    byId("seen-as-taken", HTMLButtonElement).disabled = state.isAsTaken;
  });
  host.onPhoto(() => showLimit(host));
}

/** @param {Host} host */
function showLimit(host) {
  const [limited_px = 0, side_px = 1] = host.ask((studio) => [studio.photoLimitedPx, Math.max(...studio.photoSize)]) ?? [];
  const line = byId("in-photo-limit", HTMLParagraphElement);
  const text = limited_px > MIN_LIMIT_SHARE * side_px ? t("in-photo.limited", { px: formatNumber(limited_px, 0) }) : "";
  if (line.textContent !== text) line.textContent = text;
}

/** @param {Host} host */
function setUpBrush(host) {
  const { min, max, step, neutral } = host.answer((studio) => studio.brushRange);
  const box = byId("brush", HTMLInputElement);
  const size = slider(host, "brush-size", { label: "brush.size", longLabel: "brush.size.long", unit: "px", min, max, step, neutral }, (studio, px) =>
    box.checked ? studio.setBrush(px) : undefined,
  );
  box.addEventListener("change", () => host.act((studio) => studio.setBrush(box.checked ? size.value : undefined)));
  onAction("brush-undo", () => host.act((studio) => studio.undo()));
  onAction("brush-redo", () => host.act((studio) => studio.redo()));
  onAction("brush-clear", () => host.act((studio) => studio.clearStrokes()));
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
  let isCommittedAlongView = false;
  host.onChange(({ isAlongView }) => {
    isCommittedAlongView = isAlongView;
    note.hidden = !isAlongView;
  });
  host.onTick(({ editing, isAlongView }) => {
    note.hidden = !(editing ? isAlongView : isCommittedAlongView);
  });
  onAction("show-depth", () => host.act((studio) => studio.showDepth()));
}

/**
 * @param {Host} host
 * @param {string} id id of the slider's container
 * @param {Pick<import("./slider.js").SliderOptions, "label" | "longLabel" | "unit" | "min" | "max" | "step" | "neutral">} options
 * @param {(studio: import("../../wasm/rosto-studio-web.js").Studio, value: number) => import("../viewport/host.js").ChangeName | void} set
 */
function slider(host, id, options, set) {
  /** @type {Slider} */
  const made = new Slider({
    ...options,
    onInput: () => host.act((studio) => set(studio, made.value)),
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
