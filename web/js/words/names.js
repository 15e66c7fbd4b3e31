import { bestMatch } from "./search.js";
import { isWord, t, formatNumber } from "./words.js";

/**
 * What things are called, by their ids: the studio tells which there are, the words what people call them.
 *
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioTarget} StudioTarget
 * @typedef {Pick<StudioTarget, "kind" | "id" | "number" | "part">} Target
 */

/**
 * The name of one thing of a kind; one that nobody has named yet goes by its id.
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

/** Whether the names of points carry their numbers; only experts see them. */
let areNumbered = false;

/** @param {boolean} shown whether the names of points carry their numbers from now on */
export function numberPoints(shown) {
  areNumbered = shown;
}

/**
 * A landmark's name: anatomical, or the part of the face that it lies in.
 *
 * @param {string} id such as "left-mouth-corner" or "left-cheek-425"
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
 * A landmark's name as it is displayed: with its number for experts.
 *
 * @param {string} id
 * @param {number} number
 */
export function shownLandmarkName(id, number) {
  return areNumbered ? numberedLandmarkName(id, number) : landmarkName(id);
}

/**
 * What an edit works on.
 *
 * @param {Target} target
 */
export function targetName({ kind, id, number = 0, part }) {
  switch (kind) {
    case "landmark":
      return shownLandmarkName(id, number);
    case "point": {
      const name = areNumbered ? t("target.point", { n: formatNumber(number, 0) }) : t("target.point.plain");
      return part === undefined ? name : `${name} ${idName("near", part)}`;
    }
    case "slider":
      return idName("slider", id);
    case "vertices":
      return t("target.vertices", { n: formatNumber(number, 0) });
    case "symmetry":
      return t("target.symmetry");
    default:
      return idName(kind, id);
  }
}

/**
 * Says it and frees it; nothing of nothing.
 *
 * @param {StudioTarget | undefined} target
 */
export function announceOnce(target) {
  if (!target) return undefined;
  const { kind, id, number, part } = target;
  target.free();
  return targetName({ kind, id, number, part });
}

/**
 * The vertex that is meant by a number, or the landmark whose name fits best; undefined where there is none that could be
 * selected.
 *
 * @param {string} text
 * @param {string[]} landmarkIds
 * @param {number} selectable how many vertices can be selected, from 0
 */
export function vertexCalled(text, landmarkIds, selectable) {
  const wanted = text.trim();
  if (/^\d+$/.test(wanted)) return Number(wanted) < selectable ? Number(wanted) : undefined;
  return bestMatch(wanted, landmarkIds.map((id, number) => numberedLandmarkName(id, number)));
}
