/**
 * How well a name answers what was typed, best first; names that do not answer it at all have no rank.
 *
 * @typedef {(name: string, wanted: string) => boolean} Rank
 * @type {Rank[]}
 */
const RANKS = [
  (name, wanted) => name === wanted,
  (name, wanted) => name.startsWith(wanted) && /^ ?\d*$/.test(name.slice(wanted.length)),
  (name, wanted) => name.startsWith(`${wanted} `),
  (name, wanted) => name.startsWith(wanted),
  (name, wanted) => hasWords(name, wanted),
  (name, wanted) => name.includes(wanted),
];

/**
 * The place of the name that is meant most likely: the whole name, the name but for its number, one that begins with what
 * was typed, one with words that begin so, one that has it anywhere. Among equals it is the shortest. Case, accents and
 * punctuation do not count. Undefined where no name answers.
 *
 * @param {string} text as it was typed
 * @param {string[]} names
 */
export function bestMatch(text, names) {
  const wanted = plain(text);
  if (wanted === "") return undefined;
  const plainNames = names.map(plain);
  for (const answers of RANKS) {
    const places = [...plainNames.keys()].filter((place) => answers(plainNames[place] ?? "", wanted));
    const [best] = places.sort((one, other) => (plainNames[one]?.length ?? 0) - (plainNames[other]?.length ?? 0));
    if (best !== undefined) return best;
  }
  return undefined;
}

/**
 * Whether each word that is wanted begins a word of the name.
 *
 * @param {string} name
 * @param {string} wanted
 */
function hasWords(name, wanted) {
  const words = name.split(" ");
  return wanted.split(" ").every((start) => words.some((word) => word.startsWith(start)));
}

/**
 * Letters without accents, in one case, and one space between words.
 *
 * @param {string} text
 */
function plain(text) {
  const bare = text.normalize("NFD").replaceAll(/\p{M}/gu, "").toLowerCase();
  return bare.replaceAll(/[^\p{L}\p{N}]+/gu, " ").trim();
}
