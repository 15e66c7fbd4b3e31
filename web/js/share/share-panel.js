import { byId } from "../page/dom.js";
import { ClipPanel } from "./clip-panel.js";
import { faceLooks } from "./face-looks.js";
import { setUpPairPanel } from "./pair-panel.js";

/**
 * What the face is shown to others by.
 *
 * @param {import("../viewport/workbench.js").Workbench} bench
 * @param {import("../work/autosave.js").Autosave} keeper
 */
export function setUpSharePanel(bench, keeper) {
  setUpPairPanel(bench, keeper, () => faceLooks(bench, byId("picture-transparent", HTMLInputElement).checked));
  new ClipPanel(bench, keeper);
}
