/** What was chosen in this visit, for browsers that store nothing. */
const chosen = new Map();

/**
 * What the visitor chose, now or in an earlier visit.
 *
 * @param {string} name
 * @returns {string | undefined}
 */
export function remembered(name) {
  return chosen.get(name) ?? stored(name);
}

/**
 * Remembers a choice for the next visit. A browser may refuse that; then it holds until the page is left.
 *
 * @param {string} name
 * @param {string} choice
 */
export function remember(name, choice) {
  chosen.set(name, choice);
  try {
    localStorage.setItem(`rosto.${name}`, choice);
  } catch {
    // Storage that is blocked or full is no reason to stop.
  }
}

/** @param {string} name */
function stored(name) {
  try {
    return localStorage.getItem(`rosto.${name}`) ?? undefined;
  } catch {
    return undefined;
  }
}
