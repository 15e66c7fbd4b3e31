/** Session storage, which survives a reload of the tab. */
const SLOT = "rosto.slot";

/** The slot that this tab had open before a reload. */
export function tabSlot() {
  try {
    return sessionStorage.getItem(SLOT);
  } catch {
    return null;
  }
}

/** @param slot of the open face */
export function rememberTabSlot(slot: string) {
  try {
    sessionStorage.setItem(SLOT, slot);
  } catch {
    // Storage is blocked: the next visit offers the latest work instead.
  }
}
