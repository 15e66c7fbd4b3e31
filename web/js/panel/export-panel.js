import { byId, make, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { afterNextFrame } from "../page/tasks.js";
import { toast } from "../page/toast.js";
import { setUpArLink } from "../share/ar-link.js";
import { canSend, send } from "../share/send.js";
import { canCopyPictures, copyPicture, viewPicture } from "../share/view-picture.js";
import { studioModule } from "../viewport/studio-module.js";
import { onLocaleChange, isWord, t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { pngOf } from "../work/pixels.js";
import { withFileChoices, exportedFile } from "../work/exported-file.js";
import { ExportFacts } from "./export-facts.js";
import { fileChoices, isChecked, printChoices } from "./file-choices.js";
import { PrintPanel } from "./print-panel.js";
import { VerdictLine } from "./verdict-line.js";

/**
 * @typedef {import("../page/validator.js").Validator} Validator
 * @typedef {import("../viewport/whole-texture.js").WholeTexture} WholeTexture
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 * @typedef {(format: string) => Promise<File>} MakeFile
 */

/**
 * Sets up the export tab: mesh files, printing, AR, projects and pictures.
 *
 * @param {Host} host
 * @param {Autosave} autosave
 * @param {Validator} validator
 * @param {WholeTexture} texture
 */
export function setUpExportPanel(host, autosave, validator, texture) {
  const showError = (/** @type {unknown} */ error) => host.fail(error);
  const [plain, printed] = host.answer((studio) => [studio.plainFormats, studio.printedFormats]);
  const makeFile = async (/** @type {string} */ format) => {
    const { extension, type } = fileType(host, format);
    const chosen = printed.includes(format) ? printChoices() : fileChoices();
    const bytes = await exportedFile(host, texture, format, chosen);
    return new File([/** @type {BlobPart} */ (bytes)], meshName(host, autosave, extension), { type });
  };
  const saveAs = (/** @type {string} */ format) => makeFile(format).then(saveFile);
  const nameOf = (/** @type {string} */ extension) => meshName(host, autosave, extension);
  offerGlb({ host, validator, makeFile, nameOf });
  offerFormats("plain", plain, (format) => saveAs(format).catch(showError));
  const print = new PrintPanel(host);
  offerFormats("printed", printed, (format) => saveAs(format).catch((error) => print.showError(error)));
  setUpArLink(() => makeFile("usdz"), showError);
  onAction("save-project", () => makeProject(host, autosave).then(saveFile, showError));
  onAction("download-json", () => saveAs("json").catch(showError));
  offerPicture(host, autosave);
}

/**
 * Sets up the buttons for the GLB: validate, download and share.
 *
 * @param {{ host: Host, validator: Validator, makeFile: MakeFile, nameOf: (extension: string) => string }} context
 */
function offerGlb({ host, validator, makeFile, nameOf }) {
  const facts = new ExportFacts(host, nameOf);
  const verdict = new VerdictLine(host);
  const make = async () => {
    const file = await makeFile("glb");
    facts.setFile(file);
    return file;
  };
  const check = () => makeChecked(host, nameOf("glb"), make, validator, verdict);
  onAction("check-glb", check);
  onAction("download-glb", async () => {
    const file = await check();
    if (file) saveFile(file);
  });
  byId("share-glb", HTMLButtonElement).hidden = !canSend(host.answer((studio) => studio.mediaType("glb")), "face.glb");
  const shareOrSave = async (/** @type {File} */ file) => (await send(file)) || saveFile(file);
  onAction("share-glb", () => make().then(shareOrSave).catch((error) => host.fail(error)));
}

/**
 * Adds a download button and help text for each format.
 *
 * @param {"plain" | "printed"} kind
 * @param {string[]} formats
 * @param {(format: string) => void} saveAs
 */
function offerFormats(kind, formats, saveAs) {
  const buttons = formats.map((format) => {
    const button = make("button", "button small", format.toUpperCase());
    button.type = "button";
    button.dataset["action"] = `download-${format}`;
    return button;
  });
  byId(`${kind}-formats`, HTMLDivElement).replaceChildren(...buttons);
  for (const format of formats) onAction(`download-${format}`, () => saveAs(format));
  onLocaleChange(() => {
    const help = formats.map((format) => `format.${format}.help`).filter(isWord);
    byId(`${kind}-formats-help`, HTMLParagraphElement).textContent = help.map((key) => t(key)).join(" ");
  });
}

/**
 * File extension under the current options, and media type.
 *
 * @param {Host} host
 * @param {string} format
 */
function fileType(host, format) {
  const extension = withFileChoices(fileChoices(), (choices) => host.answer((studio) => studio.fileEnding(format, choices)));
  return { extension, type: extension === "zip" ? "application/zip" : host.answer((studio) => studio.mediaType(format)) };
}

/**
 * Makes the GLB and shows the validator's verdict. Returns undefined on failure.
 *
 * @param {Host} host
 * @param {string} name file name
 * @param {() => Promise<File>} make
 * @param {Validator} validator
 * @param {VerdictLine} line
 */
async function makeChecked(host, name, make, validator, line) {
  line.show({ file: name, outcome: "checking" });
  // Lets the browser paint "checking" before the export blocks the page.
  await afterNextFrame();
  try {
    const file = await make();
    const verdict = await validator.check(new Uint8Array(await file.arrayBuffer()));
    line.conclude({ file: name, bytes: file.size, outcome: verdict ?? "unchecked" });
    return file;
  } catch (error) {
    line.show(undefined);
    host.fail(error);
    return undefined;
  }
}

/**
 * @param {Host} host
 * @param {Autosave} autosave
 * @param {string} extension
 */
function meshName(host, autosave, extension) {
  const points = host.read((state) => (state.chosen("density") === String(studioModule().defaultDensity()) ? undefined : state.vertexCount));
  return fileName(autosave.face, extension, points);
}

/**
 * @param {Host} host
 * @param {Autosave} autosave
 */
async function makeProject(host, autosave) {
  const { face } = autosave;
  if (!face) throw { code: "no-face", message: "no face is open", hint: "" };
  const png = new Uint8Array(await (await pngOf(face)).arrayBuffer());
  const bytes = host.answer((studio) => studio.projectFile(png));
  return new File([/** @type {BlobPart} */ (bytes)], fileName(face, "rosto"), { type: "application/octet-stream" });
}

/**
 * Sets up saving and copying the view as a picture.
 *
 * @param {Host} host
 * @param {Autosave} autosave
 */
function offerPicture(host, autosave) {
  const showError = (/** @type {unknown} */ error) => host.fail(error);
  const picture = () => viewPicture(host, isChecked("picture-transparent"));
  onAction("download-picture", () => {
    const name = fileName(autosave.face, "png");
    picture().then((png) => saveFile(new File([png], name, { type: png.type })), showError);
  });
  byId("copy-picture", HTMLButtonElement).hidden = !canCopyPictures();
  onAction("copy-picture", () => copyPicture(picture()).then(() => toast(t("export.copied")), showError));
}

/** @param {File} file */
function saveFile(file) {
  download(file, file.name, file.type);
  toast(t("export.done", { file: file.name }));
}
