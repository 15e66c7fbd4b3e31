import { nextTask } from "../page/tasks.js";
import { foundIn } from "../work/photos.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").Studio} Studio
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 * @typedef {import("../../wasm/rosto-studio-web.js").ChangeName} ChangeName
 */

/** So many pixels are taken in one task: few enough that none keeps the page from answering. */
const STRIP_PX = 2 ** 18;

/**
 * Gives the studio the picture of a face, some rows at a time, for as long as it is wanted. Resolves to whether it was to
 * the end.
 *
 * @param {Host} host
 * @param {OpenedFace} face
 * @param {() => boolean} isWanted
 * @param {number} [place] of the photo among those of the face to be opened
 */
export async function openPicture(host, { picture, pictureWidth_px: width, pictureHeight_px: height }, isWanted, place = 0) {
  host.attempt((studio) => studio.openPicture(width, height, place));
  await inStrips(host, picture, width, (studio, rows) => studio.addPictureRows(rows), isWanted);
  return isWanted();
}

/**
 * Gives the studio pixels, some rows in each task, for as long as they are wanted.
 *
 * @param {Host} host
 * @param {Uint8Array} pixels RGBA, row by row
 * @param {number} width px
 * @param {(studio: Studio, rows: Uint8Array) => ChangeName | void} add
 * @param {() => boolean} isWanted
 */
export async function inStrips(host, pixels, width, add, isWanted) {
  const strip_bytes = 4 * width * Math.ceil(STRIP_PX / width);
  for (let at = 0; at < pixels.length && isWanted(); at += strip_bytes) {
    host.attempt((studio) => add(studio, pixels.subarray(at, at + strip_bytes)));
    await nextTask();
  }
}

/**
 * Gives the studio the pictures of a face's photos, and what was found in all but the last.
 *
 * @param {Host} host
 * @param {OpenedFace[]} photos
 * @param {() => boolean} isWanted
 */
export async function openPictures(host, photos, isWanted) {
  for (const [place, photo] of photos.entries()) {
    if (!(await openPicture(host, photo, isWanted, place))) return false;
    if (place === photos.length - 1) return true;
    host.attempt((studio) => studio.keepPhoto(...foundIn(photo)));
  }
  return true;
}

/**
 * Has the studio take a face whose pictures it was given: whole or not at all.
 *
 * @param {Host} host
 * @param {OpenedFace[]} photos of the face
 * @param {import("../work/work.js").Done} [done] to it before
 */
export function takeFace(host, photos, done) {
  const last = photos.at(-1);
  if (!last) throw new Error("a face without a photo");
  host.attempt((studio) => {
    const found = foundIn(last);
    if (!done) return studio.openFace(...found);
    const { triangulation, density, edits, photo } = done;
    return studio.openWork(...found, triangulation, density, edits, photo);
  });
  const { preferences } = done ?? {};
  if (preferences) host.act((studio) => studio.prefer(preferences));
}
