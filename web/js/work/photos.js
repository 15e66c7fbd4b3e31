/**
 * A face that is seen in several photos: one leads, and the others tell how deep it is.
 *
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 */

/**
 * The photos of a face in the order that they were given in.
 *
 * @param {OpenedFace} face
 * @returns {OpenedFace[]}
 */
export function photosOf({ further = [], place = 0, ...lead }) {
  return [...further.slice(0, place), lead, ...further.slice(place)];
}

/**
 * Where a photo is among those of a face. It is the same photo for as long as it has the landmarks that were found in it,
 * wherever it is and whatever is known of its lens.
 *
 * @param {OpenedFace | undefined} face
 * @param {OpenedFace} photo
 * @returns {number | undefined} nothing if it is none of them
 */
export function placeOf(face, photo) {
  const place = face ? photosOf(face).findIndex(({ landmarks }) => landmarks === photo.landmarks) : -1;
  return place < 0 ? undefined : place;
}

/**
 * The face of several photos, of which one leads.
 *
 * @param {OpenedFace[]} photos in the order that they were given in
 * @param {number} place of the one that leads
 * @param {string | undefined} name of the files made of it
 * @returns {OpenedFace}
 */
export function faceOf(photos, place, name) {
  const lead = photos[place];
  if (!lead) throw new Error("none of the photos leads");
  const named = name === undefined ? lead : { ...lead, name };
  return photos.length === 1 ? named : { ...named, place, further: photos.filter((photo) => photo !== lead) };
}

/**
 * What is found in a photo, in the order in which the studio takes it.
 *
 * @param {OpenedFace} photo
 * @returns {[Float32Array, number, number, Uint8Array, string]}
 */
export function foundIn({ landmarks, width_px, height_px, colours, lens }) {
  return [landmarks, width_px, height_px, colours, lens];
}

/**
 * What the studio tells of the open face's photos, in the order that they were given in.
 *
 * @param {import("../../wasm/rosto-studio-web.js").Studio} studio
 */
export function factsOf(studio) {
  return studio.photos().map((photo) => {
    const { leads, yawDeg, turn, adds } = photo;
    photo.free();
    return { leads, yawDeg, turn, adds };
  });
}
