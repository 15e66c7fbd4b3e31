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
  onCheck("wireframe", (shown) => host.apply({ wireframe: shown }));
  host.canvas.addEventListener("keydown", (event) => {
    if (event.key.toLowerCase() === "w" && !event.ctrlKey && !event.metaKey) byId("wireframe", HTMLInputElement).click();
  });
  onCheck("dots", (shown) => host.apply({ dots: shown }));
  onCheck("turntable", (turns) => host.apply({ turntable: turns }));
  host.onChange((state) => {
    byId("wireframe", HTMLInputElement).checked = state.wireframe;
    byId("dots", HTMLInputElement).checked = state.dots;
    byId("turntable", HTMLInputElement).checked = state.turntable;
  });
  onAction("reset-view", () => host.apply({ "go-to": "reset" }));
  for (const side of /** @type {const} */ (["front", "left", "top"])) {
    onAction(`view-${side}`, () => host.apply({ "go-to": side }));
  }
  followMotionSetting(host);
}

/** @param {Host} host */
function setUpBackground(host) {
  const colour = byId("background-colour", HTMLInputElement);
  const plain = byId("background-plain", HTMLInputElement);
  const apply = () => {
    const { red, green, blue } = chosenColour(colour);
    host.apply({ background: plain.checked ? [red, green, blue] : undefined });
  };
  plain.addEventListener("change", apply);
  colour.addEventListener("input", () => {
    plain.checked = true;
    apply();
  });
  host.onChange(({ background }) => {
    plain.checked = background !== undefined;
    if (background) colour.value = hex(background);
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
  const apply = () => host.apply({ "reduced-motion": setting.matches });
  setting.addEventListener("change", apply);
  apply();
}
