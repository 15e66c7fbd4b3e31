/**
 * @typedef {import("./face.js").Face} Face
 *
 * @typedef {object} ShownFace
 * @property {Face} face
 * @property {Face[]} faces all faces of the photo, including `face`
 */

/** Number of earlier photos that are offered. */
const MAX_PHOTOS = 3;

/**
 * The faces shown before `now`, latest first, without duplicates, limited to the latest photos.
 *
 * @param {(ShownFace | undefined)[]} shown latest first
 * @param {Face} now
 * @returns {ShownFace[]}
 */
export function shownBefore(shown, now) {
  const others = shown.filter((entry) => entry !== undefined).filter(({ face }) => face !== now);
  const unique = others.filter(({ face }, index) => others.findIndex((other) => other.face === face) === index);
  const photos = [...new Set(unique.map(({ face }) => firstFileKey(face)))].filter((photo) => photo !== firstFileKey(now));
  const kept = new Set([firstFileKey(now), ...photos.slice(0, MAX_PHOTOS)]);
  return unique.filter(({ face }) => kept.has(firstFileKey(face)));
}

/**
 * The faces offered in the recent list: the one shown last, and the latest of each other photo.
 *
 * @param {ShownFace[]} before latest first
 * @param {Face[]} faces of the current photo
 * @returns {Face[]}
 */
export function recentFaces(before, faces) {
  const photos = new Set(faces.map(firstFileKey));
  return before
    .filter(({ face }, index) => {
      const isNew = !photos.has(firstFileKey(face));
      photos.add(firstFileKey(face));
      return index === 0 || isNew;
    })
    .map(({ face }) => face);
}

/** Key of a face's first file. @param {Face} face */
function firstFileKey({ files }) {
  return files[0]?.key;
}
