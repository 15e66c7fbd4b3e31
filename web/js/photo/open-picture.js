import { nextTask } from "../page/tasks.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").Studio} Studio
 * @typedef {import("../../wasm/rosto-studio-web.js").ChangeName} ChangeName
 */

/** So many pixels are taken in one task: few enough that none keeps the page from answering. */
const STRIP_PX = 2 ** 18;

/**
 * Gives the studio the picture of a face, some rows at a time, for as long as it is wanted. Resolves to whether it was to
 * the end.
 *
 * @param {Workbench} bench
 * @param {import("../work/work.js").OpenedFace} face
 * @param {() => boolean} isWanted
 * @param {number} [place] of the photo among those of the face to be opened
 */
export async function openPicture(bench, { picture, pictureWidth_px: width, pictureHeight_px: height }, isWanted, place = 0) {
  bench.attempt((studio) => studio.openPicture(width, height, place));
  await inStrips(bench, picture, width, (studio, rows) => studio.addPictureRows(rows), isWanted);
  return isWanted();
}

/**
 * Gives the studio pixels, some rows in each task, for as long as they are wanted.
 *
 * @param {Workbench} bench
 * @param {Uint8Array} pixels RGBA, row by row
 * @param {number} width px
 * @param {(studio: Studio, rows: Uint8Array) => ChangeName | void} add
 * @param {() => boolean} isWanted
 */
export async function inStrips(bench, pixels, width, add, isWanted) {
  const strip_bytes = 4 * width * Math.ceil(STRIP_PX / width);
  for (let at = 0; at < pixels.length && isWanted(); at += strip_bytes) {
    bench.attempt((studio) => add(studio, pixels.subarray(at, at + strip_bytes)));
    await nextTask();
  }
}
