import { byId, onAction } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../../wasm/rosto-studio-web.js").PaintName} PaintName
 */

/** The light comes from the upper left until someone moves it. */
const LIGHT = { azimuth_deg: -35, elevation_deg: 40, strength_percent: 100 };

/**
 * How the face is painted, lit and looked at.
 *
 * @param {Workbench} bench
 */
export function setUpViewPanel(bench) {
  setUpPaint(bench);
  setUpLight(bench);
  onAction("reset-view", () => bench.look((studio) => studio.view("reset")));
  for (const side of /** @type {const} */ (["front", "left", "top"])) {
    onAction(`view-${side}`, () => bench.look((studio) => studio.view(side)));
  }
}

/** @param {Workbench} bench */
function setUpPaint(bench) {
  byId("paint", HTMLFieldSetElement).addEventListener("change", (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    bench.look((studio) => studio.setPaint(/** @type {PaintName} */ (value)));
  });
}

/** @param {Workbench} bench */
function setUpLight(bench) {
  const apply = () => bench.look((studio) => studio.setLight(azimuth.value, elevation.value, strength.value / 100));
  const common = { step: 1, onInput: apply, onCommit: apply, onCancel: () => {} };
  const azimuth = new Slider({
    ...common,
    label: "light.azimuth",
    longLabel: "light.azimuth.long",
    unit: "°",
    min: -180,
    max: 180,
    neutral: LIGHT.azimuth_deg,
  });
  const elevation = new Slider({
    ...common,
    label: "light.elevation",
    longLabel: "light.elevation.long",
    unit: "°",
    min: -90,
    max: 90,
    neutral: LIGHT.elevation_deg,
  });
  const strength = new Slider({
    ...common,
    label: "light.strength",
    longLabel: "light.strength.long",
    unit: "%",
    min: 0,
    max: 200,
    neutral: LIGHT.strength_percent,
  });
  byId("light-sliders", HTMLFieldSetElement).append(azimuth.element, elevation.element, strength.element);
  apply();
}
