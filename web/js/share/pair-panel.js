import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { toast } from "../page/toast.js";
import { t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { canSend, send } from "./send.js";
import { sideBySide } from "./side-by-side.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {{ face: import("../work/face.js").Face | undefined }} Opening
 * @typedef {import("./side-by-side.js").Picture} Picture
 */

const TYPE = "image/png";

/**
 * Sets up the buttons that download or share the face before and after as one picture.
 *
 * @param {Host} host
 * @param {Opening} opening
 * @param {() => Promise<{ before: Picture, after: Picture }>} draw
 */
export function setUpPairPanel(host, opening, draw) {
  const make = async () => {
    const name = fileName(opening.face, "png", "before-after");
    const { before, after } = await draw();
    return new File([await sideBySide(before, after, { before: t("before"), after: t("after") })], name, { type: TYPE });
  };
  const onError = (/** @type {unknown} */ error) => host.fail(error);
  onAction("download-pair", () => make().then(save).catch(onError));
  byId("share-pair", HTMLButtonElement).hidden = !canSend(TYPE);
  onAction("share-pair", () => make().then(share).catch(onError));
}

/** @param {File} file */
async function share(file) {
  if (!(await send(file))) save(file);
}

/** @param {File} file */
function save(file) {
  download(file, file.name, file.type);
  toast(t("export.done", { file: file.name }));
}
