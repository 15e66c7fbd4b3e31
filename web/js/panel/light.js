import { byId, chosenColour, hex } from "../page/dom.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../../wasm/rosto-studio-web.js").LightSettings} LightSettings
 * @typedef {import("../words/words.js").WordKey} WordKey
 */

/** Radius of the sphere, in units of the SVG. */
const SPHERE = 40;

/**
 * Sets up the light: dragging on a sphere, or exact sliders.
 *
 * @param {Host} host
 */
export function setUpLight(host) {
  let light = host.answer((studio) => studio.state()).light;
  const set = (/** @type {Partial<LightSettings>} */ part) => {
    light = { ...light, ...part };
    host.apply({ light });
    showSun(light.azimuthDeg, light.elevationDeg);
  };
  const apply = () => {
    const [azimuthDeg = 0, elevationDeg = 0, strength = 0, ambient = 0] = sliders.map(({ value }) => value);
    set({ azimuthDeg, elevationDeg, strength: strength / 100, ambient: ambient / 100 });
  };
  const sliders = [
    slider("light.azimuth", "light.azimuth.long", "°", [-180, 180], light.azimuthDeg, apply),
    slider("light.elevation", "light.elevation.long", "°", [-90, 90], light.elevationDeg, apply),
    slider("light.strength", "light.strength.long", "%", [0, 200], 100 * light.strength, apply),
    slider("light.ambient", "light.ambient.long", "%", [0, 100], 100 * light.ambient, apply),
  ];
  byId("light-sliders", HTMLDivElement).append(...sliders.map(({ element }) => element));
  const [around, height] = sliders;
  onSphereDrag((azimuth_deg, elevation_deg) => {
    if (around) around.value = azimuth_deg;
    if (height) height.value = elevation_deg;
    apply();
  });
  const colour = byId("light-colour", HTMLInputElement);
  colour.addEventListener("input", () => {
    const { red, green, blue } = chosenColour(colour);
    set({ colour: [red, green, blue] });
  });
  const onPhoto = byId("light-photo", HTMLInputElement);
  onPhoto.addEventListener("change", () => host.apply({ "picture-light": onPhoto.checked }));
  // The display mode is not part of the document, so choosing it fires no change.
  for (const choice of [byId("shading", HTMLDivElement), onPhoto]) choice.addEventListener("change", () => host.read(showLamp));
  host.onChange((state) => {
    light = state.light;
    showLamp(state);
    const values = [light.azimuthDeg, light.elevationDeg, 100 * light.strength, 100 * light.ambient];
    for (const [place, slider] of sliders.entries()) slider.value = values[place] ?? 0;
    colour.value = hex(light.colour);
    showSun(light.azimuthDeg, light.elevationDeg);
  });
}

/**
 * Disables the lamp while the unlit photo is shown.
 *
 * @param {import("../viewport/host.js").State} state
 */
function showLamp(state) {
  const isPhoto = state.chosen["shading"] === "picture";
  byId("light-photo", HTMLInputElement).checked = state.photoLit;
  byId("light-photo-field", HTMLLabelElement).hidden = !isPhoto;
  byId("lamp", HTMLFieldSetElement).disabled = isPhoto && !state.photoLit;
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
  const noop = () => {};
  return new Slider({ label, longLabel, unit, min, max, step: 1, neutral, onInput: apply, onCommit: apply, onCancel: noop });
}

/** @param {(azimuth_deg: number, elevation_deg: number) => void} onMove */
function onSphereDrag(onMove) {
  const sphere = document.getElementById("light-sphere");
  if (!(sphere instanceof SVGSVGElement)) return;
  const move = (/** @type {PointerEvent} */ event) => {
    const box = sphere.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width - 0.5) * 2.4;
    const y = (0.5 - (event.clientY - box.top) / box.height) * 2.4;
    const radius = Math.max(1, Math.hypot(x, y));
    const toViewer = Math.sqrt(Math.max(0, 1 - (x * x + y * y) / (radius * radius)));
    onMove(degrees(Math.atan2(x / radius, toViewer)), degrees(Math.asin(y / radius)));
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
