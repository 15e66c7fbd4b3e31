import { byId, onAction } from "../page/dom.js";
import { download } from "../page/download.js";
import { showError } from "../page/notice.js";
import { toast } from "../page/toast.js";
import { onLocaleChange, t } from "../words/words.js";
import { fileName } from "../work/file-name.js";
import { pngOf } from "../work/pixels.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 * @typedef {"png" | "jpeg"} PhotoFormat
 */

/** @type {Record<PhotoFormat, string>} */
const EXTENSIONS = { png: "png", jpeg: "jpg" };

/**
 * Sets up the download of the edited photo at full size. The worker draws it, to keep the main thread responsive.
 *
 * @param {Host} host
 * @param {{ face: OpenedFace | undefined }} autosave
 * @param {import("../photo/vision-client.js").VisionClient} vision
 */
export function setUpPhotoFile(host, autosave, vision) {
  const help = byId("export-photo-help", HTMLParagraphElement);
  let isWriting = false;
  const updateHelp = () => {
    const { face } = autosave;
    if (isWriting) help.textContent = t("export.photo.wait");
    else if (face && !face.photo) help.textContent = t("export.photo.small", { width: face.pictureWidth_px, height: face.pictureHeight_px });
    else help.textContent = t("export.photo.help");
  };
  const save = async (/** @type {PhotoFormat} */ format) => {
    const { face } = autosave;
    if (!face || isWriting) return;
    isWriting = true;
    updateHelp();
    try {
      const name = fileName(face, EXTENSIONS[format], "edited");
      download(await editedPhoto(host, face, vision, format), name, `image/${format}`);
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

/**
 * Returns the file if it is still readable: the user may have deleted it meanwhile.
 *
 * @param {Blob | undefined} file
 */
async function readable(file) {
  try {
    await file?.slice(0, 1).arrayBuffer();
    return file;
  } catch {
    return undefined;
  }
}

/**
 * @param {Host} host
 * @param {OpenedFace} face
 * @param {import("../photo/vision-client.js").VisionClient} vision
 * @param {PhotoFormat} format
 */
async function editedPhoto(host, face, vision, format) {
  const warp = host.ask((studio) => studio.photoWarp());
  const [from_px, to_px, triangles] = warp ? [warp.fromPx, warp.toPx, warp.triangles] : [new Float64Array(), new Float64Array(), new Uint32Array()];
  warp?.free();
  const photo = (await readable(face.photo)) ?? (await pngOf(face));
  return vision.draw({ photo, width_px: face.width_px, from_px, to_px, triangles, format: `image/${format}` });
}
