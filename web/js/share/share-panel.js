import { byId } from "../page/dom.js";
import { ClipPanel } from "./clip-panel.js";
import { beforeAndAfter } from "./before-and-after.js";
import { setUpPairPanel } from "./pair-panel.js";

/**
 * Sets up the before-and-after picture and the clip.
 *
 * @param {import("../viewport/host.js").Host} host
 * @param {import("../work/autosave.js").Autosave} autosave
 */
export function setUpSharePanel(host, autosave) {
  setUpPairPanel(host, autosave, () => beforeAndAfter(host, byId("picture-transparent", HTMLInputElement).checked));
  new ClipPanel(host, autosave);
}
