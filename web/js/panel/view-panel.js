import { byId, chosenColour, onAction } from "../page/dom.js";
import { inEveryLanguage, say } from "../words/words.js";
import { untilWaitIsSaid } from "./hand-choice.js";
import { setUpLight } from "./light.js";
import { Slider } from "./slider.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../../wasm/rosto-studio-web.js").PaintName} PaintName
 * @typedef {import("../../wasm/rosto-studio-web.js").TriangulationName} TriangulationName
 */

const TURNTABLE_DEG_PER_S = 24;

/**
 * How the face is painted, lit and looked at.
 *
 * @param {Workbench} bench
 */
export function setUpViewPanel(bench) {
  setUpPaint(bench);
  setUpLight(bench);
  setUpBackground(bench);
  setUpBeforeAfter(bench);
  onCheck("wireframe", (shown) => bench.look((studio) => studio.setWireframe(shown)));
  bench.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "w" && !event.ctrlKey && !event.metaKey) byId("wireframe", HTMLInputElement).click();
  });
  onCheck("dots", (shown) => bench.look((studio) => studio.setDots(shown)));
  onCheck("turntable", (turns) => bench.look((studio) => studio.setTurntable(turns ? TURNTABLE_DEG_PER_S : 0)));
  inEveryLanguage(nameDensities);
  for (const select of densities()) {
    select.addEventListener("change", async () => {
      await untilWaitIsSaid();
      chooseDensity(bench, Number(select.value));
    });
  }
  byId("triangulation", HTMLSelectElement).addEventListener("change", () => chooseTriangulation(bench, chosenTriangulation()));
  chooseTriangulation(bench, chosenTriangulation());
  onAction("reset-view", () => bench.look((studio) => studio.view("reset")));
  for (const side of /** @type {const} */ (["front", "left", "top"])) {
    onAction(`view-${side}`, () => bench.look((studio) => studio.view(side)));
  }
  followMotionSetting(bench);
}

/** Whether eyes and mouth are open or filled. */
export function chosenTriangulation() {
  return /** @type {TriangulationName} */ (byId("triangulation", HTMLSelectElement).value);
}

/**
 * @param {Workbench} bench
 * @param {TriangulationName} triangulation
 */
export function chooseTriangulation(bench, triangulation) {
  byId("triangulation", HTMLSelectElement).value = triangulation;
  bench.act((studio) => studio.setTriangulation(triangulation));
}

/** How often the mesh that is shown and exported is subdivided. */
export function chosenDensity() {
  return Number(byId("density", HTMLSelectElement).value);
}

/**
 * @param {Workbench} bench
 * @param {number} density
 */
export function chooseDensity(bench, density) {
  for (const select of densities()) select.value = String(density);
  bench.act((studio) => studio.setDensity(density));
}

/** Writes the choices anew in the page's language. */
function nameDensities() {
  for (const select of densities()) {
    const chosen = select.value || "0";
    const names = /** @type {const} */ (["density.0", "density.1", "density.2", "density.3"]).map((name) => say(name));
    select.replaceChildren(...names.map((name, times) => new Option(name, String(times))));
    select.value = chosen;
  }
}

/** The same choice stands where points are taken, where the mesh is seen, and where it is exported. */
function densities() {
  return /** @type {NodeListOf<HTMLSelectElement>} */ (document.querySelectorAll("select.density"));
}

/** @param {Workbench} bench */
function setUpPaint(bench) {
  const legend = byId("paint-legend", HTMLDivElement);
  const write = () => {
    const paint = legend.dataset["paint"];
    const text = byId("paint-legend-text", HTMLParagraphElement);
    if (paint === "response") text.textContent = say("legend.response");
    if (paint === "distortion") text.textContent = say("legend.distortion");
  };
  byId("paint", HTMLFieldSetElement).addEventListener("change", (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    legend.dataset["paint"] = value;
    legend.hidden = value !== "response" && value !== "distortion";
    write();
    bench.look((studio) => studio.setPaint(/** @type {PaintName} */ (value)));
  });
  inEveryLanguage(write);
}

/** @param {Workbench} bench */
function setUpBackground(bench) {
  const colour = byId("background-colour", HTMLInputElement);
  const plain = byId("background-plain", HTMLInputElement);
  const apply = () => {
    const { red, green, blue } = chosenColour(colour);
    bench.look((studio) => (plain.checked ? studio.setBackdrop(red, green, blue) : studio.setGround()));
  };
  plain.addEventListener("change", apply);
  colour.addEventListener("input", () => {
    plain.checked = true;
    apply();
  });
}

/**
 * The face as it was found: while a key or a button is held, or by degrees.
 *
 * @param {Workbench} bench
 */
function setUpBeforeAfter(bench) {
  const button = byId("compare", HTMLButtonElement);
  const apply = () => bench.look((studio) => studio.setBefore(slider.value / 100));
  const slider = new Slider({
    label: "before",
    longLabel: "before.long",
    unit: "%",
    min: 0,
    max: 100,
    step: 1,
    neutral: 0,
    onInput: apply,
    onCommit: apply,
    onCancel: () => {},
  });
  byId("before-slider", HTMLFieldSetElement).append(slider.element);
  const hold = (/** @type {boolean} */ held) => {
    button.setAttribute("aria-pressed", String(held));
    bench.look((studio) => studio.setBefore(held ? 1 : slider.value / 100));
  };
  button.addEventListener("pointerdown", () => hold(true));
  for (const end of ["pointerup", "pointerleave", "pointercancel", "blur"]) button.addEventListener(end, () => hold(false));
  button.addEventListener("keydown", (event) => {
    if (event.key === "Enter" || event.key === " ") hold(true);
  });
  button.addEventListener("keyup", () => hold(false));
  bench.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "b" && !event.repeat) hold(true);
  });
  bench.canvas.addEventListener("keyup", (event) => {
    if (event.key.toLowerCase() === "b") hold(false);
  });
}

/**
 * @param {string} id
 * @param {(checked: boolean) => void} apply
 */
function onCheck(id, apply) {
  const box = byId(id, HTMLInputElement);
  box.addEventListener("change", () => apply(box.checked));
}

/** @param {Workbench} bench */
function followMotionSetting(bench) {
  const setting = matchMedia("(prefers-reduced-motion: reduce)");
  const apply = () => bench.look((studio) => studio.setReducedMotion(setting.matches));
  setting.addEventListener("change", apply);
  apply();
}
