/**
 * Everything needed to go on with a face: what the worker found, and what was done since.
 *
 * @typedef {{ face: OpenedFace } & Done} Work
 *
 * @typedef {object} Done
 * @property {string} edits the studio's own versioned JSON
 * @property {string} triangulation that the edits were made on
 * @property {number} density how often the mesh is subdivided
 * @property {string} [preferences] choices and view, as the studio tells them
 *
 * @typedef {object} OpenedFace
 * @property {string} [name] of the files made of it, without an ending; works kept by earlier versions have none
 * @property {number} width_px of the upright photo in which the landmarks were found
 * @property {number} height_px
 * @property {Float32Array} landmarks 468 × (x/W, y/H, z/W)
 * @property {Uint8Array} colours 468 × sRGB
 * @property {number} pictureWidth_px
 * @property {number} pictureHeight_px
 * @property {Uint8Array} picture RGBA, upright, row by row
 */

/**
 * The faces that the worker found, with the picture they share.
 *
 * @param {import("../worker/protocol.js").FoundFaces} found
 * @param {string} name of their photo
 * @returns {OpenedFace[]}
 */
export function facesOf(found, name) {
  const { width_px, height_px, pictureWidth_px, pictureHeight_px, picture } = found;
  return found.faces.map(({ landmarks, colours }, index) => ({
    ...{ width_px, height_px, landmarks, colours, pictureWidth_px, pictureHeight_px, picture },
    name: index === 0 ? name : `${name}-${index + 1}`,
  }));
}
