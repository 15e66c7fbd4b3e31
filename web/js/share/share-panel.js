import { byId } from "../page/dom.js";
import { ClipPanel } from "./clip-panel.js";
import { beforeAndAfter } from "./before-and-after.js";
import { setUpPairPanel } from "./pair-panel.js";

/**
 * Sets up the before-and-after picture and the clip.
 *
 * @param {import("../viewport/host.js").Host} host
 * @param {{ face: import("../work/face.js").Face | undefined }} opening
 */
export function setUpSharePanel(host, opening) {
  setUpPairPanel(host, opening, () => beforeAndAfter(host, byId("picture-transparent", HTMLInputElement).checked));
  new ClipPanel(host, opening);
}
