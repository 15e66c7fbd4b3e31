import { byId, make, onAction } from "../page/dom.js";
import { idName, landmarkName } from "../words/names.js";
import { onLocaleChange, t, formatNumber } from "../words/words.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 *
 * @typedef {object} About facts about the face that the studio reports as JSON
 * @property {string} lens
 * @property {number} [distance_m]
 * @property {number} [distance_error] relative standard deviation
 * @property {number} yaw_deg
 * @property {number} pitch_deg
 * @property {number} roll_deg
 * @property {"irises" | "canonical"} size_from
 * @property {number} size_error
 * @property {Record<string, number>} measures_mm
 */

const CM_PER_M = 100;
const MIN_CM = 15;
const MAX_CM = 300;

/** How the photo was taken, the size of the face, and a measuring tape. */
export class SizePanel {
  #host;
  #landmarkIds;
  #measureIds;
  #section = byId("section-size", HTMLDetailsElement);
  #distance;
  /** @type {number | undefined} vertex at the start of the tape */
  #from;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
    this.#landmarkIds = host.catalogue.landmarks;
    this.#measureIds = host.catalogue.measures;
    this.#distance = new Slider({
      ...{ label: "size.distance", longLabel: "size.distance.long", unit: "cm", min: MIN_CM, max: MAX_CM, step: 1 },
      neutral: 50,
      onInput: () => this.#setLens(`distance:${this.#distance.value / CM_PER_M}`),
      onCommit: () => {},
      onCancel: () => this.#setLens(this.#foundLens()),
    });
    byId("size-distance", HTMLDivElement).append(this.#distance.element);
    onAction("distance-known", () => this.#setLens(this.#foundLens()));
    onAction("tape-start", () => this.#start());
    // Measuring along a dense mesh takes time, so it runs only while the section is open.
    this.#section.addEventListener("toggle", () => this.#show());
    host.onChange(() => this.#show());
    onLocaleChange(() => this.#show());
  }

  /** Lens by the photo's own data. */
  #foundLens() {
    return this.#host.read((state) => state.foundLens) ?? "estimated";
  }

  /** @param {string} lens */
  #setLens(lens) {
    this.#host.apply({ "photo-lens": lens });
  }

  #start() {
    this.#from = this.#host.read((state) => state.selected);
    this.#show();
  }

  #show() {
    const face = this.#host.read(({ vertexCount, selected, photoLens }) => ({ vertexCount, selected, photoLens }));
    // The start may not exist in the current mesh.
    if (face?.photoLens === undefined || (this.#from ?? 0) >= face.vertexCount) this.#from = undefined;
    if (face?.photoLens === undefined) return;
    const about = this.#host.ask((studio) => studio.about());
    if (about) this.#write(JSON.parse(about), face.selected);
  }

  /**
   * @param {About} about
   * @param {number | undefined} selected
   */
  #write(about, selected) {
    const distance_cm = about.distance_m === undefined ? undefined : about.distance_m * CM_PER_M;
    if (distance_cm !== undefined) this.#distance.value = Math.min(MAX_CM, distance_cm);
    write("size-camera", distanceText(about, distance_cm));
    const pose = { yaw: degreesText(about.yaw_deg), pitch: degreesText(about.pitch_deg), roll: degreesText(about.roll_deg) };
    write("size-pose", t("size.pose", pose));
    write("size-source", t(about.size_from === "irises" ? "size.by-irises" : "size.canonical"));
    const rows = this.#measureIds.flatMap((id) => row(id, about));
    byId("size-measures", HTMLDListElement).replaceChildren(...rows);
    write("tape-result", this.#tapeText(about.size_error, selected));
  }

  /**
   * @param {number} error relative standard deviation
   * @param {number | undefined} to
   */
  #tapeText(error, to) {
    const from = this.#from;
    if (from === undefined) return t("tape.help");
    if (to === undefined || to === from || !this.#section.open) return t("tape.next", { from: this.#name(from) });
    const [straight = 0, along = 0] = this.#host.ask((studio) => studio.measure(from, to)) ?? [];
    const lengths = { straight: millimetres(straight, error), along: millimetres(along, error) };
    return t("tape.result", { from: this.#name(from), to: this.#name(to), ...lengths });
  }

  /** @param {number} vertex */
  #name(vertex) {
    const id = this.#landmarkIds[vertex];
    return id === undefined ? String(vertex) : landmarkName(id);
  }
}

/**
 * @param {string} id
 * @param {string} text
 */
function write(id, text) {
  byId(id, HTMLParagraphElement).textContent = text;
}

/**
 * @param {About} about
 * @param {number | undefined} distance_cm
 */
function distanceText({ lens, distance_error = 0 }, distance_cm) {
  if (distance_cm === undefined) return t("size.parallel");
  const source = lens.split(":")[0];
  const distance = Math.round(distance_cm);
  if (source === "distance") return t("size.as-given", { distance });
  const error = Math.max(1, Math.round(distance_cm * distance_error));
  return t(source === "estimated" ? "size.by-face" : "size.by-lens-data", { distance, error });
}

/** @param {number} degrees */
function degreesText(degrees) {
  return `${formatNumber(Math.round(degrees), 0)}°`;
}

/**
 * @param {string} id id of a measure
 * @param {About} about
 */
function row(id, { measures_mm, size_error }) {
  return [make("dt", "", idName("measure", id)), make("dd", "", millimetres(measures_mm[id] ?? 0, size_error))];
}

/**
 * @param {number} length_mm
 * @param {number} error relative standard deviation
 */
function millimetres(length_mm, error) {
  return `${formatNumber(length_mm, 0)} mm ± ${formatNumber(Math.max(1, length_mm * error), 0)}`;
}
