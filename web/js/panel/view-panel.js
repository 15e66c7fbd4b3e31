import { byId, chosenColour, hex, onAction } from "../page/dom.js";
import { setUpLight } from "./light.js";

/** @typedef {import("../viewport/host.js").Host} Host */

/**
 * Sets up lighting, background, display options and view directions.
 *
 * @param {Host} host
 */
export function setUpViewPanel(host) {
  setUpLight(host);
  setUpBackground(host);
  onCheck("wireframe", (shown) => host.act((studio) => studio.setWireframe(shown)));
  host.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "w" && !event.ctrlKey && !event.metaKey) byId("wireframe", HTMLInputElement).click();
  });
  onCheck("dots", (shown) => host.act((studio) => studio.setDots(shown)));
  onCheck("turntable", (turns) => host.act((studio) => studio.setTurntable(turns)));
  host.onChange((state) => {
    byId("wireframe", HTMLInputElement).checked = state.wireframe;
    byId("dots", HTMLInputElement).checked = state.dots;
    byId("turntable", HTMLInputElement).checked = state.turntable;
  });
  onAction("reset-view", () => host.act((studio) => studio.view("reset")));
  for (const side of /** @type {const} */ (["front", "left", "top"])) {
    onAction(`view-${side}`, () => host.act((studio) => studio.view(side)));
  }
  followMotionSetting(host);
}

/** @param {Host} host */
function setUpBackground(host) {
  const colour = byId("background-colour", HTMLInputElement);
  const plain = byId("background-plain", HTMLInputElement);
  const apply = () => {
    const { red, green, blue } = chosenColour(colour);
    host.act((studio) => (plain.checked ? studio.setBackdrop(red, green, blue) : studio.setGround()));
  };
  plain.addEventListener("change", apply);
  colour.addEventListener("input", () => {
    plain.checked = true;
    apply();
  });
  host.onChange(({ backdrop }) => {
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

/** @param {Host} host */
function followMotionSetting(host) {
  const setting = matchMedia("(prefers-reduced-motion: reduce)");
  const apply = () => host.act((studio) => studio.setReducedMotion(setting.matches));
  setting.addEventListener("change", apply);
  apply();
}
