import { byId, chosenColour, hex, onAction } from "../page/dom.js";
import { setUpLight } from "./light.js";

/** @typedef {import("../viewport/workbench.js").Workbench} Workbench */

/**
 * How the face is lit and looked at.
 *
 * @param {Workbench} bench
 */
export function setUpViewPanel(bench) {
  setUpLight(bench);
  setUpBackground(bench);
  onCheck("wireframe", (shown) => bench.act((studio) => studio.setWireframe(shown)));
  bench.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "w" && !event.ctrlKey && !event.metaKey) byId("wireframe", HTMLInputElement).click();
  });
  onCheck("dots", (shown) => bench.act((studio) => studio.setDots(shown)));
  onCheck("turntable", (turns) => bench.act((studio) => studio.setTurntable(turns)));
  bench.onChange((state) => {
    byId("wireframe", HTMLInputElement).checked = state.wireframe;
    byId("dots", HTMLInputElement).checked = state.dots;
    byId("turntable", HTMLInputElement).checked = state.turntable;
  });
  onAction("reset-view", () => bench.act((studio) => studio.view("reset")));
  for (const side of /** @type {const} */ (["front", "left", "top"])) {
    onAction(`view-${side}`, () => bench.act((studio) => studio.view(side)));
  }
  followMotionSetting(bench);
}

/** @param {Workbench} bench */
function setUpBackground(bench) {
  const colour = byId("background-colour", HTMLInputElement);
  const plain = byId("background-plain", HTMLInputElement);
  const apply = () => {
    const { red, green, blue } = chosenColour(colour);
    bench.act((studio) => (plain.checked ? studio.setBackdrop(red, green, blue) : studio.setGround()));
  };
  plain.addEventListener("change", apply);
  colour.addEventListener("input", () => {
    plain.checked = true;
    apply();
  });
  bench.onChange(({ backdrop }) => {
    plain.checked = backdrop.length > 0;
    if (plain.checked) colour.value = hex(backdrop);
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
  const apply = () => bench.act((studio) => studio.setReducedMotion(setting.matches));
  setting.addEventListener("change", apply);
  apply();
}
