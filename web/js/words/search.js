/**
 * Match criteria, best first.
 *
 * @typedef {(name: string, query: string) => boolean} Rank
 * @type {Rank[]}
 */
const RANKS = [
  (name, query) => name === query,
  (name, query) => name.startsWith(query) && /^ ?\d*$/.test(name.slice(query.length)),
  (name, query) => name.startsWith(`${query} `),
  (name, query) => name.startsWith(query),
  (name, query) => matchesWords(name, query),
  (name, query) => name.includes(query),
];

/**
 * Index of the best match: the full name, the name without its number, leading words, a prefix, prefixes of words, or
 * any substring. Among equals, the shortest name wins. Ignores case, accents and punctuation.
 *
 * @param {string} text
 * @param {string[]} names
 * @returns {number | undefined} undefined without a match
 */
export function bestMatch(text, names) {
  const query = normalise(text);
  if (query === "") return undefined;
  const normalised = names.map(normalise);
  for (const matches of RANKS) {
    const indices = [...normalised.keys()].filter((index) => matches(normalised[index] ?? "", query));
    const [best] = indices.sort((a, b) => (normalised[a]?.length ?? 0) - (normalised[b]?.length ?? 0));
    if (best !== undefined) return best;
  }
  return undefined;
}

/**
 * Whether each word of the query is a prefix of a word of the name.
 *
 * @param {string} name
 * @param {string} query
 */
function matchesWords(name, query) {
  const words = name.split(" ");
  return query.split(" ").every((start) => words.some((word) => word.startsWith(start)));
}

/**
 * Removes accents, case and punctuation.
 *
 * @param {string} text
 */
function normalise(text) {
  const bare = text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();
  return bare.replaceAll(/[^\p{L}\p{N}]+/gu, " ").trim();
}
