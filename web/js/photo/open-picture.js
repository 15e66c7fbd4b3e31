import { nextTask } from "../page/tasks.js";
import { detectionOf } from "../work/photos.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").Studio} Studio
 * @typedef {import("../work/work.js").OpenedFace} OpenedFace
 * @typedef {import("../../wasm/rosto-studio-web.js").ChangeName} ChangeName
 */

/** Pixels copied per task: few enough to keep the page responsive. */
const STRIP_PX = 2 ** 18;

/**
 * Copies a picture into the studio, in strips. Resolves to false if it was cancelled.
 *
 * @param {Host} host
 * @param {OpenedFace} face
 * @param {() => boolean} isWanted
 * @param {number} [place] index among the photos of the face
 */
export async function openPicture(host, { picture, pictureWidth_px: width, pictureHeight_px: height }, isWanted, place = 0) {
  host.attempt((studio) => studio.openPicture(width, height, place));
  await inStrips(host, picture, width, (studio, rows) => studio.addPictureRows(rows), isWanted);
  return isWanted();
}

/**
 * Copies pixels into the studio, one strip per task, until `isWanted` returns false.
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
 * Copies the pictures of all photos into the studio, and the detections of all but the last, which {@link openFace}
 * passes.
 *
 * @param {Host} host
 * @param {OpenedFace[]} photos
 * @param {() => boolean} isWanted
 */
export async function openPictures(host, photos, isWanted) {
  for (const [place, photo] of photos.entries()) {
    if (!(await openPicture(host, photo, isWanted, place))) return false;
    if (place === photos.length - 1) return true;
    host.attempt((studio) => studio.keepPhoto(...detectionOf(photo)));
  }
  return true;
}

/**
 * Opens a face, atomically, after {@link openPictures}.
 *
 * @param {Host} host
 * @param {OpenedFace[]} photos of the face
 * @param {import("../work/work.js").EditState} [state] to restore
 */
export function openFace(host, photos, state) {
  const last = photos.at(-1);
  if (!last) throw new Error("face without a photo");
  host.attempt((studio) => {
    const detection = detectionOf(last);
    if (!state) return studio.openFace(...detection);
    const { triangulation, density, edits, photo } = state;
    return studio.openWork(...detection, triangulation, density, edits, photo);
  });
  const { preferences } = state ?? {};
  if (preferences) host.act((studio) => studio.restorePreferences(preferences));
}
