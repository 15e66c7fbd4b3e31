/** Choices of this visit, for browsers without storage. */
const chosen = new Map<string, string>();

/** Returns a choice of this or an earlier visit. */
export function remembered(name: string): string | undefined {
  try {
    return chosen.get(name) ?? localStorage.getItem(`rosto.${name}`) ?? undefined;
  } catch {
    // Storage may be blocked.
    return undefined;
  }
}

/** Stores a choice for later visits, or for this one if the browser refuses. */
export function remember(name: string, choice: string) {
  chosen.set(name, choice);
  try {
    localStorage.setItem(`rosto.${name}`, choice);
  } catch {
    // Storage may be blocked or full.
  }
}
