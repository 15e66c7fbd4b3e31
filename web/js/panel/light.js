import { byId, chosenColour } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../words/words.js").WordKey} WordKey
 */

/** The light comes from the upper left until someone moves it. */
const AZIMUTH_DEG = -35;
const ELEVATION_DEG = 40;
const STRENGTH_PERCENT = 100;
const AMBIENT_PERCENT = 40;

/** Radius of the small sphere in its own units. */
const SPHERE = 40;

/**
 * The light: dragged on a small sphere, or set exactly by numbers.
 *
 * @param {Workbench} bench
 */
export function setUpLight(bench) {
  const apply = () => {
    bench.look((studio) => studio.setLight(azimuth.value, elevation.value, strength.value / 100));
    showSun(azimuth.value, elevation.value);
  };
  const azimuth = slider("light.azimuth", "light.azimuth.long", "°", [-180, 180], AZIMUTH_DEG, apply);
  const elevation = slider("light.elevation", "light.elevation.long", "°", [-90, 90], ELEVATION_DEG, apply);
  const strength = slider("light.strength", "light.strength.long", "%", [0, 200], STRENGTH_PERCENT, apply);
  const ambient = slider("light.ambient", "light.ambient.long", "%", [0, 100], AMBIENT_PERCENT, () =>
    bench.look((studio) => studio.setAmbient(ambient.value / 100)),
  );
  const sliders = [azimuth, elevation, strength, ambient].map(({ element }) => element);
  byId("light-sliders", HTMLDivElement).append(...sliders);
  onSphereDrag((azimuth_deg, elevation_deg) => {
    azimuth.value = azimuth_deg;
    elevation.value = elevation_deg;
    apply();
  });
  const colour = byId("light-colour", HTMLInputElement);
  colour.addEventListener("input", () => {
    const { red, green, blue } = chosenColour(colour);
    bench.look((studio) => studio.setLightColour(red, green, blue));
  });
  apply();
}

/**
 * @param {WordKey} label
 * @param {WordKey} longLabel
 * @param {string} unit
 * @param {[number, number]} range
 * @param {number} neutral
 * @param {() => void} apply
 */
function slider(label, longLabel, unit, [min, max], neutral, apply) {
  const nothing = () => {};
  return new Slider({ label, longLabel, unit, min, max, step: 1, neutral, onInput: apply, onCommit: apply, onCancel: nothing });
}

/** @param {(azimuth_deg: number, elevation_deg: number) => void} told */
function onSphereDrag(told) {
  const sphere = document.getElementById("light-sphere");
  if (!(sphere instanceof SVGSVGElement)) return;
  const move = (/** @type {PointerEvent} */ event) => {
    const box = sphere.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width - 0.5) * 2.4;
    const y = (0.5 - (event.clientY - box.top) / box.height) * 2.4;
    const reach = Math.max(1, Math.hypot(x, y));
    const toViewer = Math.sqrt(Math.max(0, 1 - (x * x + y * y) / (reach * reach)));
    told(degrees(Math.atan2(x / reach, toViewer)), degrees(Math.asin(y / reach)));
  };
  sphere.addEventListener("pointerdown", (event) => {
    sphere.setPointerCapture(event.pointerId);
    move(event);
  });
  sphere.addEventListener("pointermove", (event) => {
    if (sphere.hasPointerCapture(event.pointerId)) move(event);
  });
}

/**
 * @param {number} azimuth_deg
 * @param {number} elevation_deg
 */
function showSun(azimuth_deg, elevation_deg) {
  const sun = document.getElementById("light-sun");
  const azimuth = (azimuth_deg * Math.PI) / 180;
  const elevation = (elevation_deg * Math.PI) / 180;
  sun?.setAttribute("cx", String(SPHERE * Math.sin(azimuth) * Math.cos(elevation)));
  sun?.setAttribute("cy", String(-SPHERE * Math.sin(elevation)));
  sun?.toggleAttribute("data-behind", Math.cos(azimuth) < 0);
}

/** @param {number} radians */
function degrees(radians) {
  return Math.round((radians * 180) / Math.PI);
}
