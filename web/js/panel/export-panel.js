import { byId, make, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { afterNextFrame } from "../page/tasks.js";
import { toast } from "../page/toast.js";
import { studioModule } from "../viewport/studio-module.js";
import { inEveryLanguage, isWord, say } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { pngOf } from "../work/pixels.js";
import { VerdictLine } from "./verdict-line.js";

/**
 * @typedef {import("../page/validator.js").Validator} Validator
 * @typedef {import("../../wasm/rosto-studio-web.js").FileChoices} FileChoices
 * @typedef {import("../viewport/whole-texture.js").WholeTexture} WholeTexture
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 */

/**
 * Files made of the face as it stands.
 *
 * @param {Workbench} bench
 * @param {Autosave} keeper
 * @param {Validator} validator
 * @param {WholeTexture} texture
 */
export function setUpExportPanel(bench, keeper, validator, texture) {
  const verdict = new VerdictLine(bench);
  const fileOf = (/** @type {string} */ format) => writtenFile(bench, texture, format);
  const check = () => checked(bench, meshName(bench, keeper, "glb"), () => fileOf("glb"), validator, verdict);
  onAction("check-glb", check);
  onAction("download-glb", async () => {
    const name = meshName(bench, keeper, "glb");
    const file = await check();
    if (file) save(bench, name, bench.studio.mediaType("glb"), () => file);
  });
  const saveAs = (/** @type {string} */ format) => saveMesh(bench, keeper, format, () => fileOf(format));
  offerPlainFormats(bench, saveAs);
  onAction("save-project", () => saveProject(bench, keeper).catch((error) => bench.fail(error)));
  onAction("download-picture", () => savePicture(bench, keeper));
  onAction("download-json", () => saveAs("json"));
}

/**
 * A button for each format about which there is nothing to choose, with a word on each.
 *
 * @param {Workbench} bench
 * @param {(format: string) => void} saveAs
 */
function offerPlainFormats(bench, saveAs) {
  const formats = bench.studio.plainFormats;
  const buttons = formats.map((format) => {
    const button = make("button", "button small", format.toUpperCase());
    button.type = "button";
    button.dataset["action"] = `download-${format}`;
    return button;
  });
  byId("plain-formats", HTMLDivElement).replaceChildren(...buttons);
  for (const format of formats) onAction(`download-${format}`, () => saveAs(format));
  inEveryLanguage(() => {
    const help = formats.map((format) => `format.${format}.help`).filter(isWord);
    byId("plain-formats-help", HTMLParagraphElement).textContent = help.map((key) => say(key)).join(" ");
  });
}

/**
 * @param {Workbench} bench
 * @param {Autosave} keeper
 * @param {string} format
 * @param {() => Promise<Uint8Array>} write
 */
async function saveMesh(bench, keeper, format, write) {
  const ending = withChoices((choices) => bench.studio.fileEnding(format, choices));
  const type = ending === "zip" ? "application/zip" : bench.studio.mediaType(format);
  const name = meshName(bench, keeper, ending);
  try {
    const file = await write();
    save(bench, name, type, () => file);
  } catch (error) {
    bench.fail(error);
  }
}

/**
 * The face as a file, as it is asked for. One that is painted with the whole face waits for its texture.
 *
 * @param {Workbench} bench
 * @param {WholeTexture} texture
 * @param {string} format
 */
async function writtenFile(bench, texture, format) {
  if (chosen("base-colour") === "whole" && bench.studio.isPainted(format)) await texture.ready();
  return withChoices((choices) => bench.studio.exportFile(format, choices));
}

/**
 * Does something with what is chosen about files.
 *
 * @template T
 * @param {(choices: FileChoices) => T} then
 */
function withChoices(then) {
  const choices = new (studioModule().FileChoices)();
  try {
    choices.choose("base-colour", chosen("base-colour"));
    choices.choose("material", isChecked("export-unlit") ? "unlit" : "lit");
    choices.choose("edits", isChecked("export-morphs") ? "morph-targets" : "shape");
    choices.choose("expressions", isChecked("export-expressions") ? "morph-targets" : "shape");
    choices.choose("units", chosen("export-units"));
    return then(choices);
  } finally {
    choices.free();
  }
}

/**
 * The GLB as it is asked for, with the validator's verdict on it shown; nothing if it cannot be made.
 *
 * @param {Workbench} bench
 * @param {string} name of the file
 * @param {() => Promise<Uint8Array>} write
 * @param {Validator} validator
 * @param {VerdictLine} line
 */
async function checked(bench, name, write, validator, line) {
  line.show({ file: name, outcome: "checking" });
  // The words are on the screen before the file is made.
  await afterNextFrame();
  try {
    const file = await write();
    const verdict = await validator.check(file);
    line.conclude({ file: name, bytes: file.length, outcome: verdict ?? "unchecked" });
    return file;
  } catch (error) {
    line.show(undefined);
    bench.fail(error);
    return undefined;
  }
}

/**
 * @param {Workbench} bench
 * @param {Autosave} keeper
 * @param {string} ending
 */
function meshName(bench, keeper, ending) {
  const points = bench.read((state) => (state.chosen("density") === String(studioModule().usualDensity()) ? undefined : state.vertexCount));
  return fileName(keeper.face, ending, points);
}

/**
 * @param {Workbench} bench
 * @param {Autosave} keeper
 */
async function saveProject(bench, keeper) {
  const { face } = keeper;
  if (!face) return;
  const png = new Uint8Array(await (await pngOf(face)).arrayBuffer());
  save(bench, fileName(face, "rosto"), "application/octet-stream", () => bench.studio.projectFile(png));
}

/**
 * The view as it is, at twice the size of the screen.
 *
 * @param {Workbench} bench
 * @param {Autosave} keeper
 */
async function savePicture(bench, keeper) {
  const name = fileName(keeper.face, "png");
  const transparent = isChecked("picture-transparent");
  const { width, height } = bench.canvas;
  try {
    const snapshot = await bench.studio.snapshot(2 * width, 2 * height, transparent);
    const size = { pictureWidth_px: snapshot.width, pictureHeight_px: snapshot.height };
    const png = await pngOf({ picture: snapshot.takePixels(), ...size });
    snapshot.free();
    save(bench, name, "image/png", () => png);
  } catch (error) {
    bench.fail(error);
  }
}

/**
 * @param {Workbench} bench
 * @param {string} name
 * @param {string} type
 * @param {() => Uint8Array | string | Blob} produce
 */
function save(bench, name, type, produce) {
  try {
    download(produce(), name, type);
    toast(say("export.done", { file: name }));
  } catch (error) {
    bench.fail(error);
  }
}

/** @param {string} name of a group of radio buttons */
function chosen(name) {
  const input = /** @type {HTMLInputElement | null} */ (document.querySelector(`input[name="${name}"]:checked`));
  return input?.value ?? "";
}

/** @param {string} id of a checkbox */
function isChecked(id) {
  return byId(id, HTMLInputElement).checked;
}
