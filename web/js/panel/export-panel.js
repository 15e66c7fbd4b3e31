import { byId, make, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { setUpArLink } from "../share/ar-link.js";
import { canSend, send } from "../share/send.js";
import { canCopyPictures, copyPicture, viewPicture } from "../share/view-picture.js";
import { onLocaleChange, isWord, t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { ExportFacts } from "./export-facts.js";
import { fileChoices, isChecked, printChoices } from "./file-choices.js";
import { PrintPanel } from "./print-panel.js";
import { VerdictLine } from "./verdict-line.js";

/**
 * @typedef {import("../page/validator.js").Validator} Validator
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../opening.js").Opening} Opening
 * @typedef {(format: string) => Promise<File>} MakeFile
 */

/**
 * Sets up the export tab: mesh files, printing, AR, projects and pictures.
 *
 * @param {Host} host
 * @param {Opening} opening
 * @param {Validator} validator
 * @param {import("../work/face-files.js").FaceFiles} files
 */
export function setUpExportPanel(host, opening, validator, files) {
  const showError = (/** @type {unknown} */ error) => host.fail(error);
  const { formats } = host.catalogue;
  const plain = formats.filter(({ isPlain }) => isPlain).map(({ id }) => id);
  const printed = formats.filter(({ isPrinted }) => isPrinted).map(({ id }) => id);
  const naming = () => meshNaming(host, opening);
  const makeFile = async (/** @type {string} */ format) => {
    const [chosen, nameOf] = [printed.includes(format) ? printChoices() : fileChoices(), naming()];
    const { bytes, extension, mediaType } = await files.mesh(format, chosen);
    return new File([bytes], nameOf(extension), { type: mediaType });
  };
  const saveAs = (/** @type {string} */ format) => makeFile(format).then(saveFile);
  offerGlb({ host, validator, makeFile, nameOf: (extension) => naming()(extension) });
  offerFormats("plain", plain, (format) => saveAs(format).catch(showError));
  const print = new PrintPanel(host, files);
  offerFormats("printed", printed, (format) => saveAs(format).catch((error) => print.showError(error)));
  setUpArLink(() => makeFile("usdz"), showError);
  const makeProject = async () => {
    const name = fileName(opening.face, "rosto");
    return new File([await files.project()], name, { type: "application/octet-stream" });
  };
  onAction("save-project", () => makeProject().then(saveFile, showError));
  onAction("download-json", () => saveAs("json").catch(showError));
  offerPicture(host, opening);
}

/**
 * Sets up the buttons for the GLB: validate, download and share.
 *
 * @param {{ host: Host, validator: Validator, makeFile: MakeFile, nameOf: (extension: string) => string }} context
 */
function offerGlb({ host, validator, makeFile, nameOf }) {
  const glb = host.catalogue.formats.find(({ id }) => id === "glb");
  const facts = new ExportFacts(host, nameOf);
  const verdict = new VerdictLine(host);
  const make = async () => {
    const setSize = facts.begin();
    const file = await makeFile("glb");
    setSize(file.size);
    return file;
  };
  const check = () => makeChecked(host, nameOf("glb"), make, validator, verdict);
  onAction("check-glb", check);
  onAction("download-glb", async () => {
    const file = await check();
    if (file) saveFile(file);
  });
  byId("share-glb", HTMLButtonElement).hidden = !canSend(glb?.mediaType ?? "", "face.glb");
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
 * Names files of the face and density that are open now, by their extension.
 *
 * @param {Host} host
 * @param {Opening} opening
 */
function meshNaming(host, { face }) {
  const points = host.read((state) => (state.chosen["density"] === String(host.catalogue.defaultDensity) ? undefined : state.vertexCount));
  return (/** @type {string} */ extension) => fileName(face, extension, points);
}

/**
 * Sets up saving and copying the view as a picture.
 *
 * @param {Host} host
 * @param {Opening} opening
 */
function offerPicture(host, opening) {
  const showError = (/** @type {unknown} */ error) => host.fail(error);
  const picture = () => viewPicture(host, isChecked("picture-transparent"));
  onAction("download-picture", () => {
    const name = fileName(opening.face, "png");
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
