/** Match criteria, best first. */
type Rank = (name: string, query: string) => boolean;
const RANKS: Rank[] = [
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
 * @returns undefined without a match
 */
export function bestMatch(text: string, names: string[]): number | undefined {
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

/** Whether each word of the query is a prefix of a word of the name. */
function matchesWords(name: string, query: string) {
  const words = name.split(" ");
  return query.split(" ").every((start) => words.some((word) => word.startsWith(start)));
}

/** Removes accents, case and punctuation. */
function normalise(text: string) {
  const bare = text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();
  return bare.replaceAll(/[^\p{L}\p{N}]+/gu, " ").trim();
}
