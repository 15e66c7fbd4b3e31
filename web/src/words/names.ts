import { isWord, t } from "./words.ts";

/** Match criteria for normalised names, best first. */
const RANKS: ((name: string, query: string) => boolean)[] = [
  (name, query) => name.startsWith(query) && /^ ?\d*$/.test(name.slice(query.length)),
  (name, query) => name.startsWith(`${query} `),
  (name, query) => name.startsWith(query),
  (name, query) => query.split(" ").every((start) => ` ${name}`.includes(` ${start}`)),
  (name, query) => name.includes(query),
];

/** Whether labels include the numbers of points, for experts. */
let showNumbers = false;

export function setPointNumbersShown(shown: boolean) {
  showNumbers = shown;
}

/**
 * The name for an id; falls back to the id itself.
 *
 * @param kind such as "operator"
 * @param id such as "mean-value"
 */
export function idName(kind: string, id: string) {
  const key = `${kind}.${id}`;
  return isWord(key) ? t(key) : id.replaceAll("-", " ");
}

/**
 * A landmark's anatomical name, or the name of its part of the face; with its number for experts.
 *
 * @param id such as "left-mouth-corner" or "left-cheek-427"
 */
export function landmarkLabel(id: string, number: number, isNumbered = showNumbers) {
  const part = /^(.*)-\d+$/.exec(id)?.[1];
  const name = part === undefined ? idName("landmark", id) : idName("part", part);
  return isNumbered ? `${name} · ${number}` : name;
}

/**
 * The vertex with a number, or the landmark whose name matches best; undefined without a match.
 *
 * @param selectableCount the vertices below this number can be selected
 */
export function findVertex(query: string, landmarkIds: string[], selectableCount: number) {
  const text = query.trim();
  if (/^\d+$/.test(text)) return Number(text) < selectableCount ? Number(text) : undefined;
  return bestMatch(text, landmarkIds.map((id, number) => landmarkLabel(id, number, true)));
}

/**
 * Index of the best match: the full name, the name without its number, leading words, a prefix, prefixes of words, or
 * any substring. Among equals, the shortest name wins. Ignores case, accents and punctuation.
 *
 * @returns undefined without a match
 */
export function bestMatch(text: string, names: string[]): number | undefined {
  const query = normalise(text);
  if (query === "") return undefined;
  const candidates = names.map((name, index) => ({ name: normalise(name), index }));
  candidates.sort((a, b) => a.name.length - b.name.length);
  for (const matches of RANKS) {
    const best = candidates.find(({ name }) => matches(name, query));
    if (best) return best.index;
  }
  return undefined;
}

/** Removes accents, case and punctuation. */
function normalise(text: string) {
  const bare = text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();
  return bare.replaceAll(/[^\p{L}\p{N}]+/gu, " ").trim();
}
