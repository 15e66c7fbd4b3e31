import { bestMatch } from "./search.ts";
import { isWord, t } from "./words.ts";

/**
 * The name for an id; falls back to the id itself.
 *
 * @param kind such as "region"
 * @param id such as "left-brow"
 */
export function idName(kind: string, id: string) {
  const key = `${kind}.${id}`;
  if (isWord(key)) return t(key);
  const plain = id.replaceAll("-", " ");
  return kind === "slider" ? plain.charAt(0).toUpperCase() + plain.slice(1) : plain;
}

/** Whether labels include the numbers of points, for experts. */
let showNumbers = false;

export function setPointNumbersShown(shown: boolean) {
  showNumbers = shown;
}

/**
 * A landmark's anatomical name, or the name of its part of the face.
 *
 * @param id such as "left-mouth-corner" or "left-cheek-427"
 */
export function landmarkName(id: string) {
  const part = /^(?<part>.*)-\d+$/.exec(id)?.groups?.["part"];
  return part === undefined ? idName("landmark", id) : idName("part", part);
}

/** A landmark's name with its number, such as "nose tip · 1". */
export function numberedLandmarkName(id: string, number: number) {
  return `${landmarkName(id)} · ${number}`;
}

/** A landmark's label, with its number for experts. */
export function landmarkLabel(id: string, number: number) {
  return showNumbers ? numberedLandmarkName(id, number) : landmarkName(id);
}

/**
 * The vertex with a number, or the landmark whose name matches best; undefined without a match.
 *
 * @param selectableCount the vertices below this number can be selected
 */
export function findVertex(query: string, landmarkIds: string[], selectableCount: number) {
  const text = query.trim();
  if (/^\d+$/.test(text)) return Number(text) < selectableCount ? Number(text) : undefined;
  return bestMatch(text, landmarkIds.map((id, number) => numberedLandmarkName(id, number)));
}
