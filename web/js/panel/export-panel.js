import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { showTrouble } from "../page/notice.js";
import { say } from "../words/words.js";
import { projectFile } from "../work/project-file.js";
import { announce } from "./landmark-panel.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../work/work-keeper.js").WorkKeeper} WorkKeeper
 * @typedef {import("../../wasm/rosto-studio-web.js").ExportPaintName} ExportPaintName
 * @typedef {import("../../wasm/rosto-studio-web.js").UnitsName} UnitsName
 */

/**
 * Files made of the face as it stands.
 *
 * @param {Workbench} bench
 * @param {WorkKeeper} keeper
 */
export function setUpExportPanel(bench, keeper) {
  onAction("download-glb", () => {
    const paint = /** @type {ExportPaintName} */ (chosen("export-paint"));
    save("rosto.glb", "model/gltf-binary", () => bench.studio.exportGlb(paint));
  });
  onAction("save-project", () => saveProject(keeper));
  onAction("download-picture", () => savePicture(bench));
  onAction("download-json", () => {
    const units = /** @type {UnitsName} */ (chosen("export-units"));
    save("rosto.json", "application/json", () => bench.studio.meshJson(units));
  });
}

/** @param {WorkKeeper} keeper */
async function saveProject(keeper) {
  const { work } = keeper;
  if (!work) return;
  const file = await projectFile(work);
  save("face.rosto", file.type, () => file);
}

/**
 * The view as it is, at twice the size of the screen.
 *
 * @param {Workbench} bench
 */
async function savePicture(bench) {
  const transparent = byId("picture-transparent", HTMLInputElement).checked;
  const { width, height } = bench.canvas;
  try {
    const snapshot = await bench.studio.snapshot(2 * width, 2 * height, transparent);
    const canvas = new OffscreenCanvas(snapshot.width, snapshot.height);
    const pixels = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (snapshot.takePixels().buffer));
    canvas.getContext("2d")?.putImageData(new ImageData(pixels, snapshot.width, snapshot.height), 0, 0);
    snapshot.free();
    const png = await canvas.convertToBlob({ type: "image/png" });
    save("rosto.png", "image/png", () => png);
  } catch (error) {
    showTrouble(error);
  }
}

/**
 * @param {string} name
 * @param {string} type
 * @param {() => Uint8Array | string | Blob} produce
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
