import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { showError } from "../page/notice.js";
import { toast } from "../page/toast.js";
import { onLocaleChange, t } from "../words/words.js";
import { leadPhotoOf } from "../work/face.js";
import { fileName } from "../work/file-name.js";

/**
 * @typedef {import("../work/face.js").Face} Face
 * @typedef {"png" | "jpeg"} PhotoFormat
 *
 * @typedef {object} Context
 * @property {import("../viewport/host.js").Host} host
 * @property {{ face: Face | undefined }} opening
 * @property {import("../work/face-files.js").FaceFiles} files
 * @property {{ pictureSize: { width: number, height: number } }} overlay
 */

/** @type {Record<PhotoFormat, string>} */
const EXTENSIONS = { png: "png", jpeg: "jpg" };

/**
 * Sets up the download of the edited photo, at full size if its own file was opened.
 *
 * @param {Context} context
 */
export function setUpPhotoFile({ host, opening, files, overlay }) {
  const help = byId("export-photo-help", HTMLParagraphElement);
  let isWriting = false;
  const updateHelp = () => {
    const { face } = opening;
    if (isWriting) help.textContent = t("export.photo.wait");
    else if (face && leadPhotoOf(face).source.kind === "saved") help.textContent = t("export.photo.small", overlay.pictureSize);
    else help.textContent = t("export.photo.help");
  };
  const save = async (/** @type {PhotoFormat} */ format) => {
    const { face } = opening;
    if (!face || isWriting) return;
    isWriting = true;
    updateHelp();
    try {
      const name = fileName(face, EXTENSIONS[format], "edited");
      download(await files.editedPhoto(`image/${format}`), name, `image/${format}`);
      toast(t("export.saved", { name }));
    } catch (error) {
      showError(error);
    } finally {
      isWriting = false;
      updateHelp();
    }
  };
  for (const format of /** @type {const} */ (["png", "jpeg"])) onAction(`download-photo-${format}`, () => save(format));
  host.onChange(updateHelp);
  onLocaleChange(updateHelp);
}
