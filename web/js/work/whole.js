/**
 * Whether what was read is all there, and of the types that it was kept as.
 *
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {Omit<OpenedFace, "picture" | "further"> & { picture: Uint8Array | Blob }} KeptPhoto pixels that the browser takes as a blob are kept as one
 * @typedef {KeptPhoto & { further?: KeptPhoto[] }} KeptRow
 * @typedef {import("./drafts.js").KeptDone} KeptDone
 */

/** Three numbers for each landmark. */
const FEWEST_LANDMARKS = 3 * 468;
const COLOURS_BYTES = 3 * 468;

/**
 * @param {any} row
 * @returns {row is KeptRow}
 */
export function isFace(row) {
  const { further = [], place = 0 } = row ?? {};
  return isPhoto(row) && Array.isArray(further) && further.every(isPhoto) && isCount(place) && place <= further.length;
}

/**
 * @param {any} row
 * @returns {row is KeptDone}
 */
export function isDone(row) {
  const { edits, triangulation, density, order, photo, lens, preferences } = row ?? {};
  const isRead = isJson(edits) && typeof triangulation === "string" && isCount(density) && isCount(order);
  return isRead && [photo, lens, preferences].every(isOptionalText);
}

/** @param {any} photo */
function isPhoto(photo) {
  const { name, lens, width_px, height_px, landmarks, colours, photo: file, pictureWidth_px, pictureHeight_px, picture } = photo ?? {};
  const isSized = [width_px, height_px, pictureWidth_px, pictureHeight_px].every((side) => isCount(side) && side > 0);
  const isFound = landmarks instanceof Float32Array && landmarks.length >= FEWEST_LANDMARKS && landmarks.length % 3 === 0;
  const isColoured = colours instanceof Uint8Array && colours.length >= COLOURS_BYTES;
  const isFile = file === undefined || file instanceof Blob;
  const bytes = picture instanceof Blob ? picture.size : picture instanceof Uint8Array ? picture.length : undefined;
  const hasTexts = typeof lens === "string" && isOptionalText(name);
  return isSized && isFound && isColoured && isFile && hasTexts && bytes === pictureWidth_px * pictureHeight_px * 4;
}

/** @param {any} value */
function isCount(value) {
  return Number.isSafeInteger(value) && value >= 0;
}

/** @param {any} value */
function isOptionalText(value) {
  return value === undefined || typeof value === "string";
}

/** @param {any} text */
function isJson(text) {
  try {
    return typeof text === "string" && Boolean(JSON.parse(text));
  } catch {
    return false;
  }
}
