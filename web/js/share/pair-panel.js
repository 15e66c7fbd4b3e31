import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { say } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { canSend, send } from "./send.js";
import { sideBySide } from "./side-by-side.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 * @typedef {import("./side-by-side.js").Look} Look
 * @typedef {() => Promise<{ before: Look, after: Look }>} Looks where the two pictures come from
 */

const TYPE = "image/png";

/**
 * The face before and after as one picture: to be downloaded and, where the browser can, handed on.
 *
 * @param {Workbench} bench
 * @param {Autosave} keeper
 * @param {Looks} looks
 */
export function setUpPairPanel(bench, keeper, looks) {
  const make = async () => {
    const name = fileName(keeper.face, "png", "before-after");
    const { before, after } = await looks();
    return new File([await sideBySide(before, after, { before: say("before"), after: say("after") })], name, { type: TYPE });
  };
  const complain = (/** @type {unknown} */ error) => bench.fail(error);
  onAction("download-pair", () => make().then(keep).catch(complain));
  byId("share-pair", HTMLButtonElement).hidden = !canSend(TYPE);
  onAction("share-pair", () => make().then(handOn).catch(complain));
}

/** @param {File} file */
async function handOn(file) {
  if (!(await send(file))) keep(file);
}

/** @param {File} file */
function keep(file) {
  download(file, file.name, file.type);
  toast(say("export.done", { file: file.name }));
}
