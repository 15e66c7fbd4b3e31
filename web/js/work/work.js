/**
 * Everything needed to go on with a face: what the worker found, and what was done since.
 *
 * @typedef {{ face: OpenedFace } & Done} Work
 *
 * @typedef {object} Done
 * @property {string} edits the studio's own versioned JSON
 * @property {string} triangulation that the edits were made on
 * @property {number} density how often the mesh is subdivided
 * @property {string} [photo] what the photo alone holds, as the studio tells it; none where nothing was done to it
 * @property {string} [lens] what the photo is taken to be taken through, where that is another than was known of it
 * @property {string} [preferences] choices and view, as the studio tells them
 *
 * @typedef {object} OpenedFace
 * @property {string} [name] of the files made of it, without an ending; further photos out of a file have none
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {Float32Array} landmarks 468 or 478 × (x/W, y/H, z/W), those of the irises last
 * @property {string} lens what is known of the photo's lens, as the studio takes it
 * @property {Uint8Array} colours 468 × sRGB
 * @property {Blob} [photo] the file as it was opened; none of works that were saved without it
 * @property {number} pictureWidth_px
 * @property {number} pictureHeight_px
 * @property {Uint8Array} picture RGBA, upright, row by row
 * @property {OpenedFace[]} [further] the other photos that the face is seen in, in the order that they were given in; all above is of the one that leads
 * @property {number} [place] of the one that leads among them all
 */

/**
 * The faces that the worker found, with the picture they share.
 *
 * @param {import("../worker/protocol.js").FoundFaces} found
 * @param {string} name of their photo
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
