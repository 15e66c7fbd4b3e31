import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { canSend, send } from "./send.js";
import { sideBySide } from "./side-by-side.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../work/autosave.js").Autosave} Autosave
 * @typedef {import("./side-by-side.js").Look} Look
 * @typedef {() => Promise<{ before: Look, after: Look }>} Looks where the two pictures come from
 */

const TYPE = "image/png";

/**
 * The face before and after as one picture: to be downloaded and, where the browser can, handed on.
 *
 * @param {Host} host
 * @param {Autosave} autosave
 * @param {Looks} looks
 */
export function setUpPairPanel(host, autosave, looks) {
  const make = async () => {
    const name = fileName(autosave.face, "png", "before-after");
    const { before, after } = await looks();
    return new File([await sideBySide(before, after, { before: t("before"), after: t("after") })], name, { type: TYPE });
  };
  const complain = (/** @type {unknown} */ error) => host.fail(error);
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
  toast(t("export.done", { file: file.name }));
}
