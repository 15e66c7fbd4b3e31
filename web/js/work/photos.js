/**
 * A face with several photos: one is the lead photo, and the others contribute depth.
 *
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 */

/**
 * The photos of a face, in the order they were added.
 *
 * @param {OpenedFace} face
 * @returns {OpenedFace[]}
 */
export function photosOf({ further = [], place = 0, ...lead }) {
  return [...further.slice(0, place), lead, ...further.slice(place)];
}

/**
 * Index of a photo among those of a face. Photos are compared by the identity of their landmarks, as order and lens can
 * change.
 *
 * @param {OpenedFace | undefined} face
 * @param {OpenedFace} photo
 * @returns {number | undefined} undefined if the face does not have the photo
 */
export function indexOfPhoto(face, photo) {
  const index = face ? photosOf(face).findIndex(({ landmarks }) => landmarks === photo.landmarks) : -1;
  return index < 0 ? undefined : index;
}

/**
 * Combines photos into one face.
 *
 * @param {OpenedFace[]} photos in the order they were added
 * @param {number} place index of the lead photo
 * @param {string | undefined} name stem of exported file names
 * @returns {OpenedFace}
 */
export function faceFromPhotos(photos, place, name) {
  const lead = photos[place];
  if (!lead) throw new Error("no lead photo");
  const named = name === undefined ? lead : { ...lead, name };
  return photos.length === 1 ? named : { ...named, place, further: photos.filter((photo) => photo !== lead) };
}

/**
 * The detection in a photo, as leading arguments of the studio's methods.
 *
 * @param {OpenedFace} photo
 * @returns {[Float32Array, number, number, Uint8Array, string]}
 */
export function detectionOf({ landmarks, width_px, height_px, colours, lens }) {
  return [landmarks, width_px, height_px, colours, lens];
}

/**
 * The studio's facts about the open face's photos, in the order they were added.
 *
 * @param {import("../../wasm/rosto-studio-web.js").Studio} studio
 */
export function photoFacts(studio) {
  return studio.photos().map((photo) => {
    const { leads, yawDeg, turn, adds } = photo;
    photo.free();
    return { leads, yawDeg, turn, adds };
  });
}
