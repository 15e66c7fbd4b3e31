/** One Web Lock per slot, held by the tab that shows its face. */
import { withTimeout } from "./timeout.ts";

/** After this long without a lock, the held locks are queried instead. */
const ACQUIRE_MS = 1000;

const QUERY_MS = 2000;

function lockOf(slot: string) {
  return `rosto-slot-${slot}`;
}

/**
 * Locks a slot for this tab. If the browser has no locks or does not answer, the tab proceeds without one; writes still
 * detect a conflict with another tab.
 *
 * @returns the release function; undefined if another tab holds the slot
 */
export function lockSlot(slot: string): Promise<(() => void) | undefined> {
  return new Promise((resolve) => {
    let isLate = false;
    const giveUp = async () => {
      isLate = true;
      resolve((await lockedSlots([slot])).has(slot) ? undefined : () => {});
    };
    setTimeout(giveUp, ACQUIRE_MS);
    const onGranted = () => isLate || new Promise((release) => resolve(() => release(undefined)));
    Promise.resolve().then(() => navigator.locks.request(lockOf(slot), onGranted)).catch(giveUp);
  });
}

/** The slots that a tab holds, this one included; empty if the browser does not answer. */
export async function lockedSlots(slots: string[]) {
  try {
    const { held = [] } = await withTimeout(QUERY_MS, navigator.locks.query(), "querying the locks");
    const names = new Set(held.map(({ name }) => name));
    return new Set(slots.filter((slot) => names.has(lockOf(slot))));
  } catch {
    return new Set();
  }
}
