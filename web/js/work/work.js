/**
 * Everything needed to restore a face: the worker's result and the edits made since.
 *
 * @typedef {{ face: OpenedFace } & EditState} Work
 *
 * @typedef {object} EditState
 * @property {string} edits the studio's versioned JSON
 * @property {string} triangulation on which the edits were made
 * @property {number} density subdivision level
 * @property {string} [photo] edits of the photo alone, in the studio's format
 * @property {string} [lens] set by the user, if it differs from the lens detected
 * @property {string} [preferences] choices and view, in the studio's format
 *
 * @typedef {object} OpenedFace
 * @property {string} [name] stem of exported file names; absent for further photos from a saved file
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {Float32Array} landmarks 468 or 478 × (x/W, y/H, z/W), irises last
 * @property {string} lens detected in the photo, in the studio's format
 * @property {Uint8Array} colours 468 × sRGB
 * @property {Blob} [photo] the original file; absent if the work was saved without it
 * @property {number} pictureWidth_px
 * @property {number} pictureHeight_px
 * @property {Uint8Array} picture RGBA, upright, row by row
 * @property {OpenedFace[]} [further] the other photos of the face, in the order they were added; the fields above
 *   describe the lead photo
 * @property {number} [place] index of the lead photo among all photos
 */

/**
 * Converts the worker's result; the faces share one picture.
 *
 * @param {import("../worker/protocol.js").FoundFaces} found
 * @param {string} name of the photo
 * @param {Blob} photo
 * @returns {OpenedFace[]}
 */
export function facesOf(found, name, photo) {
  const { width_px, height_px, pictureWidth_px, pictureHeight_px, picture, focalLength_mm } = found;
  const lens = focalLength_mm === undefined ? "estimated" : `exif:${focalLength_mm}`;
  return found.faces.map(({ landmarks, colours }, index) => ({
    ...{ width_px, height_px, landmarks, lens, colours, photo, pictureWidth_px, pictureHeight_px, picture },
    name: index === 0 ? name : `${name}-${index + 1}`,
  }));
}
