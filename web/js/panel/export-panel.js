import { byId, make, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { afterNextFrame } from "../page/tasks.js";
import { toast } from "../page/toast.js";
import { setUpArLink } from "../share/ar-link.js";
import { canSend, send } from "../share/send.js";
import { canCopyPictures, copyPicture, viewPicture } from "../share/view-picture.js";
import { studioModule } from "../viewport/studio-module.js";
import { inEveryLanguage, isWord, say } from "../words/words.js";
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
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 * @typedef {(format: string) => Promise<File>} MakeFile
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
  const complain = (/** @type {unknown} */ error) => bench.fail(error);
  const [plain, printed] = bench.answer((studio) => [studio.plainFormats, studio.printedFormats]);
  const makeFile = async (/** @type {string} */ format) => {
    const { ending, type } = kindOf(bench, format);
    const chosen = printed.includes(format) ? printChoices() : fileChoices();
    const bytes = await writtenFile(bench, texture, format, chosen);
    return new File([/** @type {BlobPart} */ (bytes)], meshName(bench, keeper, ending), { type });
  };
  const saveAs = (/** @type {string} */ format) => makeFile(format).then(keep);
  const nameOf = (/** @type {string} */ ending) => meshName(bench, keeper, ending);
  offerGlb({ bench, validator, makeFile, nameOf });
  offerFormats("plain", plain, (format) => saveAs(format).catch(complain));
  const print = new PrintPanel(bench);
  offerFormats("printed", printed, (format) => saveAs(format).catch((error) => print.refuse(error)));
  setUpArLink(() => makeFile("usdz"), complain);
  onAction("save-project", () => makeProject(bench, keeper).then(keep, complain));
  onAction("download-json", () => saveAs("json").catch(complain));
  offerPicture(bench, keeper);
}

/**
 * The format that the page is about: checked, downloaded, and handed to other programs where the browser can.
 *
 * @param {{ bench: Workbench, validator: Validator, makeFile: MakeFile, nameOf: (ending: string) => string }} room
 */
function offerGlb({ bench, validator, makeFile, nameOf }) {
  const facts = new ExportFacts(bench, nameOf);
  const verdict = new VerdictLine(bench);
  const make = async () => {
    const file = await makeFile("glb");
    facts.tell(file);
    return file;
  };
  const check = () => checked(bench, nameOf("glb"), make, validator, verdict);
  onAction("check-glb", check);
  onAction("download-glb", async () => {
    const file = await check();
    if (file) keep(file);
  });
  byId("share-glb", HTMLButtonElement).hidden = !canSend(bench.answer((studio) => studio.mediaType("glb")), "face.glb");
  const handOn = async (/** @type {File} */ file) => (await send(file)) || keep(file);
  onAction("share-glb", () => make().then(handOn).catch((error) => bench.fail(error)));
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
  inEveryLanguage(() => {
    const help = formats.map((format) => `format.${format}.help`).filter(isWord);
    byId(`${kind}-formats-help`, HTMLParagraphElement).textContent = help.map((key) => say(key)).join(" ");
  });
}

/**
 * How a format's file ends as it is asked for, and its media type.
 *
 * @param {Workbench} bench
 * @param {string} format
 */
function kindOf(bench, format) {
  const ending = withFileChoices(fileChoices(), (choices) => bench.answer((studio) => studio.fileEnding(format, choices)));
  return { ending, type: ending === "zip" ? "application/zip" : bench.answer((studio) => studio.mediaType(format)) };
}

/**
 * The GLB as it is asked for, with the validator's verdict on it shown; nothing if it cannot be made.
 *
 * @param {Workbench} bench
 * @param {string} name of the file
 * @param {() => Promise<File>} make
 * @param {Validator} validator
 * @param {VerdictLine} line
 */
async function checked(bench, name, make, validator, line) {
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
async function makeProject(bench, keeper) {
  const { face } = keeper;
  if (!face) throw { code: "no-face", message: "no face is open", hint: "" };
  const png = new Uint8Array(await (await pngOf(face)).arrayBuffer());
  const bytes = bench.answer((studio) => studio.projectFile(png));
  return new File([/** @type {BlobPart} */ (bytes)], fileName(face, "rosto"), { type: "application/octet-stream" });
}

/**
 * The view as a picture: saved, or copied where the browser can.
 *
 * @param {Workbench} bench
 * @param {Autosave} keeper
 */
function offerPicture(bench, keeper) {
  const complain = (/** @type {unknown} */ error) => bench.fail(error);
  const picture = () => viewPicture(bench, isChecked("picture-transparent"));
  onAction("download-picture", () => {
    const name = fileName(keeper.face, "png");
    picture().then((png) => keep(new File([png], name, { type: png.type })), complain);
  });
  byId("copy-picture", HTMLButtonElement).hidden = !canCopyPictures();
  onAction("copy-picture", () => copyPicture(picture()).then(() => toast(say("export.copied")), complain));
}

/** @param {File} file */
function keep(file) {
  download(file, file.name, file.type);
  toast(say("export.done", { file: file.name }));
}
