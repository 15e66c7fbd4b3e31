/** This tab's slot outlives a reload. */
const SLOT = "rosto.slot";

/** The slot of the face that this tab had open before it was loaded anew. */
export function ownSlot() {
  try {
    return sessionStorage.getItem(SLOT);
  } catch {
    return null;
  }
}

/** @param {string} slot of the face that is open now */
export function rememberSlot(slot) {
  try {
    sessionStorage.setItem(SLOT, slot);
  } catch {
    // The next visit then offers the latest work.
  }
}
