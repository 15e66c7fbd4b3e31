import { onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { showTrouble } from "../page/notice.js";
import { say } from "../words/words.js";
import { announce } from "./landmark-panel.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../../wasm/rosto-studio-web.js").ExportPaintName} ExportPaintName
 * @typedef {import("../../wasm/rosto-studio-web.js").UnitsName} UnitsName
 */

/**
 * Files made of the face as it stands.
 *
 * @param {Workbench} bench
 */
export function setUpExportPanel(bench) {
  onAction("download-glb", () => {
    const paint = /** @type {ExportPaintName} */ (chosen("export-paint"));
    save("rosto.glb", "model/gltf-binary", () => bench.studio.exportGlb(paint));
  });
  onAction("download-json", () => {
    const units = /** @type {UnitsName} */ (chosen("export-units"));
    save("rosto.json", "application/json", () => bench.studio.meshJson(units));
  });
}

/**
 * @param {string} name
 * @param {string} type
 * @param {() => Uint8Array | string} produce
 */
function save(name, type, produce) {
  try {
    download(produce(), name, type);
    announce(say("export.done", { file: name }));
  } catch (error) {
    showTrouble(error);
  }
}

/** @param {string} name of a group of radio buttons */
function chosen(name) {
  const input = /** @type {HTMLInputElement | null} */ (document.querySelector(`input[name="${name}"]:checked`));
  return input?.value ?? "";
}
