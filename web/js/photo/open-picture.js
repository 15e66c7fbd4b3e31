import { nextTask } from "../page/tasks.js";

/** So many pixels are taken in one task: few enough that none keeps the page from answering. */
const STRIP_PX = 2 ** 18;

/**
 * Gives the studio the picture of a face, some rows at a time.
 *
 * @param {import("../viewport/workbench.js").Studio} studio
 * @param {import("../work/work.js").OpenedFace} face
 */
export async function openPicture(studio, { picture, pictureWidth_px: width, pictureHeight_px: height }) {
  const strip_bytes = 4 * width * Math.ceil(STRIP_PX / width);
  studio.openPicture(width, height);
  for (let at = 0; at < picture.length; at += strip_bytes) {
    studio.addPictureRows(picture.subarray(at, at + strip_bytes));
    await nextTask();
  }
}
