/**
 * Type guards for database rows.
 *
 * @typedef {object} FaceRow the part of a face that rarely changes
 * @property {string} name
 * @property {(Omit<import("./face.js").SourceFile, "file"> & { file: Blob | ArrayBuffer })[]} files
 *
 * @typedef {Required<Pick<import("./face.js").Face, "photos" | "pictures" | "lead" | "edits" | "preferences">>} Work
 * @typedef {Work & { order: number }} StoredWork `order` increases with each save
 */
import { viewsOf } from "./face.js";

/**
 * @param {any} row
 * @returns {row is FaceRow}
 */
export function isFaceRow(row) {
  const { name, files } = row ?? {};
  return typeof name === "string" && Array.isArray(files) && files.every(isFile);
}

/**
 * @param {any} row
 * @returns {row is StoredWork}
 */
export function isWorkRow(row) {
  const { photos, pictures, lead, edits, preferences, order } = row ?? {};
  const hasTexts = isJson(edits) && typeof preferences === "string" && isCount(lead) && isCount(order);
  return hasTexts && Array.isArray(pictures) && lead < pictures.length && photoCount(photos) === pictures.length;
}

/** @param {any} file */
function isFile({ key, file, kind }) {
  return typeof key === "string" && (file instanceof Blob || file instanceof ArrayBuffer) && ["photo", "saved"].includes(kind);
}

/** Number of photos; undefined if the text is damaged. @param {any} photos */
function photoCount(photos) {
  try {
    return viewsOf(photos).length;
  } catch {
    return undefined;
  }
}

/** @param {any} value */
function isCount(value) {
  return Number.isSafeInteger(value) && value >= 0;
}

/** @param {any} text */
function isJson(text) {
  try {
    return typeof text === "string" && Boolean(JSON.parse(text));
  } catch {
    return false;
  }
}
