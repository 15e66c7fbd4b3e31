import { bitmapOf } from "./pixels.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").EditState} EditState
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 *
 * @typedef {object} ShownFace
 * @property {OpenedFace} face
 * @property {OpenedFace[]} faces all faces of the photo, including `face`
 *
 * @typedef {object} Loaded
 * @property {ImageBitmap} bitmap of the face's picture
 * @property {EditState} [edits] to restore
 * @property {number} [extraction_ms] time to find the landmarks
 * @property {boolean} [changedElsewhere] another program has changed the mesh in the file
 * @property {boolean} [isDoubtful] possibly not a face
 * @property {boolean} [ofThisVisit] the photo was open before
 *
 * @typedef {ShownFace & Loaded} Incoming a face ready to be opened
 */

/**
 * Prepares work read from a file or the database.
 *
 * @param {Work & { changedElsewhere?: boolean }} work
 * @returns {Promise<Incoming>}
 */
export async function fromWork({ face, changedElsewhere = false, ...edits }) {
  try {
    return { face, faces: [face], bitmap: await bitmapOf(face), edits, changedElsewhere };
  } catch (error) {
    throw { code: "bad-kept-work", message: String(error), hint: "" };
  }
}

/**
 * Prepares a face shown earlier in this visit, with its edits. The current view settings are kept.
 *
 * @param {ShownFace} shown
 * @param {EditState | undefined} last undefined if the face was never opened
 * @returns {Promise<Incoming>}
 */
export async function fromVisit({ face, faces }, last) {
  const { preferences: _, ...edits } = last ?? { edits: "", triangulation: "", density: 0 };
  return { face, faces, bitmap: await bitmapOf(face), ...(last && { edits }), ofThisVisit: true };
}

/** Number of earlier photos whose pictures stay in memory. */
const MAX_PHOTOS = 3;

/**
 * The faces shown before `now`, latest first, without duplicates, limited to the photos that stay in memory.
 *
 * @param {(ShownFace | undefined)[]} shown latest first
 * @param {OpenedFace} now
 * @returns {ShownFace[]}
 */
export function shownBefore(shown, now) {
  const others = shown.filter((entry) => entry !== undefined).filter(({ face }) => face !== now);
  const unique = others.filter(({ face }, index) => others.findIndex((other) => other.face === face) === index);
  const pictures = [...new Set(unique.map(({ face }) => face.picture))].filter((picture) => picture !== now.picture);
  const kept = new Set([now.picture, ...pictures.slice(0, MAX_PHOTOS)]);
  return unique.filter(({ face }) => kept.has(face.picture));
}

/**
 * The faces offered in the recent list: the one shown last, and the latest of each other photo.
 *
 * @param {ShownFace[]} before latest first
 * @param {OpenedFace[]} faces of the current photo
 * @returns {OpenedFace[]}
 */
export function recentFaces(before, faces) {
  const photos = new Set(faces.map(({ picture }) => picture));
  return before
    .filter(({ face }, index) => {
      const isNew = !photos.has(face.picture);
      photos.add(face.picture);
      return index === 0 || isNew;
    })
    .map(({ face }) => face);
}
