/**
 * Type guards for database rows.
 *
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {Omit<OpenedFace, "picture" | "further"> & { picture: Uint8Array | Blob }} StoredPhoto
 * @typedef {StoredPhoto & { further?: StoredPhoto[] }} FaceRow
 * @typedef {import("./drafts.js").StoredEdits} StoredEdits
 */

/** Three coordinates per landmark, without the irises. */
const MIN_COORDINATES = 3 * 468;
const COLOURS_BYTES = 3 * 468;

/**
 * @param {any} row
 * @returns {row is FaceRow}
 */
export function isFaceRow(row) {
  const { further = [], place = 0 } = row ?? {};
  return isPhoto(row) && Array.isArray(further) && further.every(isPhoto) && isCount(place) && place <= further.length;
}

/**
 * @param {any} row
 * @returns {row is StoredEdits}
 */
export function isEditRow(row) {
  const { edits, triangulation, density, order, photo, lens, preferences } = row ?? {};
  const hasRequired = isJson(edits) && typeof triangulation === "string" && isCount(density) && isCount(order);
  return hasRequired && [photo, lens, preferences].every(isOptionalText);
}

/** @param {any} photo */
function isPhoto(photo) {
  const { name, lens, width_px, height_px, landmarks, colours, photo: file, pictureWidth_px, pictureHeight_px, picture } = photo ?? {};
  const hasSizes = [width_px, height_px, pictureWidth_px, pictureHeight_px].every((side) => isCount(side) && side > 0);
  const hasLandmarks = landmarks instanceof Float32Array && landmarks.length >= MIN_COORDINATES && landmarks.length % 3 === 0;
  const hasColours = colours instanceof Uint8Array && colours.length >= COLOURS_BYTES;
  const hasValidFile = file === undefined || file instanceof Blob;
  const bytes = picture instanceof Blob ? picture.size : picture instanceof Uint8Array ? picture.length : undefined;
  const hasTexts = typeof lens === "string" && isOptionalText(name);
  return hasSizes && hasLandmarks && hasColours && hasValidFile && hasTexts && bytes === pictureWidth_px * pictureHeight_px * 4;
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
