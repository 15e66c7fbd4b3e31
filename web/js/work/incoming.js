import { bitmapOf } from "./pixels.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 *
 * @typedef {object} Shown
 * @property {OpenedFace} face
 * @property {OpenedFace[]} faces all of its photo, itself among them
 *
 * @typedef {object} Arrival
 * @property {ImageBitmap} bitmap the face's picture
 * @property {Done} [done] what was done to it before
 * @property {number} [extraction_ms] how long finding its landmarks took
 * @property {boolean} [changedElsewhere] whether the file tells of another shape than opens
 * @property {boolean} [isDoubtful] it may not be a face
 * @property {boolean} [ofThisVisit] whether its photo was open before
 *
 * @typedef {Shown & Arrival} Incoming what is ready to be opened
 */

/**
 * Work out of a file or the browser's database.
 *
 * @param {Work & { changedElsewhere?: boolean }} work
 * @returns {Promise<Incoming>}
 */
export async function fromWork({ face, changedElsewhere = false, ...done }) {
  try {
    return { face, faces: [face], bitmap: await bitmapOf(face), done, changedElsewhere };
  } catch (error) {
    throw { code: "bad-kept-work", message: String(error), hint: "" };
  }
}

/**
 * A face of this visit as it was left. How it is looked at stays as it is.
 *
 * @param {Shown} shown
 * @param {Done | undefined} left nothing if it was never on the screen
 * @returns {Promise<Incoming>}
 */
export async function fromVisit({ face, faces }, left) {
  const { preferences: _, ...done } = left ?? { edits: "", triangulation: "", density: 0 };
  return { face, faces, bitmap: await bitmapOf(face), ...(left && { done }), ofThisVisit: true };
}

/** So many photos of a visit can be gone back to: their pictures stay in memory, those of others in the database alone. */
const MOST_PHOTOS = 3;

/**
 * What was shown before a face, the latest first, each face once. What comes back after a crash takes no other's place.
 *
 * @param {(Shown | undefined)[]} shown the latest first
 * @param {OpenedFace} now
 * @returns {Shown[]}
 */
export function shownBefore(shown, now) {
  const others = shown.filter((one) => one !== undefined).filter(({ face }) => face !== now);
  const once = others.filter(({ face }, place) => others.findIndex((one) => one.face === face) === place);
  const pictures = [...new Set(once.map(({ face }) => face.picture))].filter((picture) => picture !== now.picture);
  const kept = new Set([now.picture, ...pictures.slice(0, MOST_PHOTOS)]);
  return once.filter(({ face }) => kept.has(face.picture));
}

/**
 * The faces that are offered to go back to: the one shown last, and the last one of each other photo.
 *
 * @param {Shown[]} before the latest first
 * @param {OpenedFace[]} faces of the photo that is shown
 * @returns {OpenedFace[]}
 */
export function recentFaces(before, faces) {
  const photos = new Set(faces.map(({ picture }) => picture));
  return before
    .filter(({ face }, place) => {
      const isNew = !photos.has(face.picture);
      photos.add(face.picture);
      return place === 0 || isNew;
    })
    .map(({ face }) => face);
}
