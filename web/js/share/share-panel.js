import { byId } from "../page/dom.js";
import { ClipPanel } from "./clip-panel.js";
import { faceLooks } from "./face-looks.js";
import { setUpPairPanel } from "./pair-panel.js";

/**
 * What the face is shown to others by.
 *
 * @param {import("../viewport/host.js").Host} host
 * @param {import("../work/autosave.js").Autosave} autosave
 */
export function setUpSharePanel(host, autosave) {
  setUpPairPanel(host, autosave, () => faceLooks(host, byId("picture-transparent", HTMLInputElement).checked));
  new ClipPanel(host, autosave);
}
