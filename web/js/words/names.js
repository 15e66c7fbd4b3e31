import { bestMatch } from "./search.js";
import { isWord, t } from "./words.js";

/**
 * The name for an id; falls back to the id itself.
 *
 * @param {string} kind such as "region"
 * @param {string} id such as "left-brow"
 */
export function idName(kind, id) {
  const key = `${kind}.${id}`;
  if (isWord(key)) return t(key);
  const plain = id.replaceAll("-", " ");
  return kind === "slider" ? plain.charAt(0).toUpperCase() + plain.slice(1) : plain;
}

/** Whether labels include the numbers of points, for experts. */
let showNumbers = false;

/** @param {boolean} shown */
export function setPointNumbersShown(shown) {
  showNumbers = shown;
}

/**
 * A landmark's anatomical name, or the name of its part of the face.
 *
 * @param {string} id such as "left-mouth-corner" or "left-cheek-427"
 */
export function landmarkName(id) {
  const part = /^(?<part>.*)-\d+$/.exec(id)?.groups?.["part"];
  return part === undefined ? idName("landmark", id) : idName("part", part);
}

/**
 * A landmark's name with its number, such as "nose tip · 1".
 *
 * @param {string} id
 * @param {number} number
 */
export function numberedLandmarkName(id, number) {
  return `${landmarkName(id)} · ${number}`;
}

/**
 * A landmark's label, with its number for experts.
 *
 * @param {string} id
 * @param {number} number
 */
export function landmarkLabel(id, number) {
  return showNumbers ? numberedLandmarkName(id, number) : landmarkName(id);
}

/**
 * The vertex with a number, or the landmark whose name matches best; undefined without a match.
 *
 * @param {string} query
 * @param {string[]} landmarkIds
 * @param {number} selectableCount the vertices below this number can be selected
 */
export function findVertex(query, landmarkIds, selectableCount) {
  const text = query.trim();
  if (/^\d+$/.test(text)) return Number(text) < selectableCount ? Number(text) : undefined;
  return bestMatch(text, landmarkIds.map((id, number) => numberedLandmarkName(id, number)));
}
