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
import { withFileChoices, writtenFile } from "../work/written-file.js";
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
 * Files made of the face as it stands.
 *
 * @param {Host} host
 * @param {Autosave} autosave
 * @param {Validator} validator
 * @param {WholeTexture} texture
 */
export function setUpExportPanel(host, autosave, validator, texture) {
  const complain = (/** @type {unknown} */ error) => host.fail(error);
  const [plain, printed] = host.answer((studio) => [studio.plainFormats, studio.printedFormats]);
  const makeFile = async (/** @type {string} */ format) => {
    const { ending, type } = kindOf(host, format);
    const chosen = printed.includes(format) ? printChoices() : fileChoices();
    const bytes = await writtenFile(host, texture, format, chosen);
    return new File([/** @type {BlobPart} */ (bytes)], meshName(host, autosave, ending), { type });
  };
  const saveAs = (/** @type {string} */ format) => makeFile(format).then(keep);
  const nameOf = (/** @type {string} */ ending) => meshName(host, autosave, ending);
  offerGlb({ host, validator, makeFile, nameOf });
  offerFormats("plain", plain, (format) => saveAs(format).catch(complain));
  const print = new PrintPanel(host);
  offerFormats("printed", printed, (format) => saveAs(format).catch((error) => print.refuse(error)));
  setUpArLink(() => makeFile("usdz"), complain);
  onAction("save-project", () => makeProject(host, autosave).then(keep, complain));
  onAction("download-json", () => saveAs("json").catch(complain));
  offerPicture(host, autosave);
}

/**
 * The format that the page is about: checked, downloaded, and handed to other programs where the browser can.
 *
 * @param {{ host: Host, validator: Validator, makeFile: MakeFile, nameOf: (ending: string) => string }} room
 */
function offerGlb({ host, validator, makeFile, nameOf }) {
  const facts = new ExportFacts(host, nameOf);
  const verdict = new VerdictLine(host);
  const make = async () => {
    const file = await makeFile("glb");
    facts.tell(file);
    return file;
  };
  const check = () => checked(host, nameOf("glb"), make, validator, verdict);
  onAction("check-glb", check);
  onAction("download-glb", async () => {
    const file = await check();
    if (file) keep(file);
  });
  byId("share-glb", HTMLButtonElement).hidden = !canSend(host.answer((studio) => studio.mediaType("glb")), "face.glb");
  const handOn = async (/** @type {File} */ file) => (await send(file)) || keep(file);
  onAction("share-glb", () => make().then(handOn).catch((error) => host.fail(error)));
}

/**
 * A button for each format of a kind, with a word on each.
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
 * How a format's file ends as it is asked for, and its media type.
 *
 * @param {Host} host
 * @param {string} format
 */
function kindOf(host, format) {
  const ending = withFileChoices(fileChoices(), (choices) => host.answer((studio) => studio.fileEnding(format, choices)));
  return { ending, type: ending === "zip" ? "application/zip" : host.answer((studio) => studio.mediaType(format)) };
}

/**
 * The GLB as it is asked for, with the validator's verdict on it shown; nothing if it cannot be made.
 *
 * @param {Host} host
 * @param {string} name of the file
 * @param {() => Promise<File>} make
 * @param {Validator} validator
 * @param {VerdictLine} line
 */
async function checked(host, name, make, validator, line) {
  line.show({ file: name, outcome: "checking" });
  // The words are on the screen before the file is made.
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
 * @param {string} ending
 */
function meshName(host, autosave, ending) {
  const points = host.read((state) => (state.chosen("density") === String(studioModule().usualDensity()) ? undefined : state.vertexCount));
  return fileName(autosave.face, ending, points);
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
 * The view as a picture: saved, or copied where the browser can.
 *
 * @param {Host} host
 * @param {Autosave} autosave
 */
function offerPicture(host, autosave) {
  const complain = (/** @type {unknown} */ error) => host.fail(error);
  const picture = () => viewPicture(host, isChecked("picture-transparent"));
  onAction("download-picture", () => {
    const name = fileName(autosave.face, "png");
    picture().then((png) => keep(new File([png], name, { type: png.type })), complain);
  });
  byId("copy-picture", HTMLButtonElement).hidden = !canCopyPictures();
  onAction("copy-picture", () => copyPicture(picture()).then(() => toast(t("export.copied")), complain));
}

/** @param {File} file */
function keep(file) {
  download(file, file.name, file.type);
  toast(t("export.done", { file: file.name }));
}
