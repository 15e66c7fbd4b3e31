import { nextTask } from "../page/tasks.js";

/** So many pixels are taken in one task: few enough that none keeps the page from answering. */
const STRIP_PX = 2 ** 18;

/**
 * Gives the studio the picture of a face, some rows at a time, for as long as it is wanted. Resolves to whether it was to
 * the end.
 *
 * @param {import("../viewport/workbench.js").Workbench} bench
 * @param {import("../work/work.js").OpenedFace} face
 * @param {() => boolean} isWanted
 * @param {number} [place] of the photo among those of the face to be opened
 */
export async function openPicture(bench, { picture, pictureWidth_px: width, pictureHeight_px: height }, isWanted, place = 0) {
  const strip_bytes = 4 * width * Math.ceil(STRIP_PX / width);
  bench.attempt((studio) => studio.openPicture(width, height, place));
  for (let at = 0; at < picture.length && isWanted(); at += strip_bytes) {
    bench.attempt((studio) => studio.addPictureRows(picture.subarray(at, at + strip_bytes)));
    await nextTask();
  }
  return isWanted();
}
