/** Choices of this visit, for browsers without storage. */
const chosen = new Map();

/**
 * Returns a choice of this or an earlier visit.
 *
 * @param {string} name
 * @returns {string | undefined}
 */
export function remembered(name) {
  return chosen.get(name) ?? stored(name);
}

/**
 * Stores a choice for later visits, or for this one if the browser refuses.
 *
 * @param {string} name
 * @param {string} choice
 */
export function remember(name, choice) {
  chosen.set(name, choice);
  try {
    localStorage.setItem(`rosto.${name}`, choice);
  } catch {
    // Storage may be blocked or full.
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
