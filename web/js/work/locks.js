/** Each slot has a lock, which the tab holds that shows its face. */
import { within } from "./within.js";

/** After this long without an answer a lock is looked for among those that are held. */
const PATIENCE_MS = 1000;

const QUERY_MS = 2000;

/** @param {string} slot */
function lockOf(slot) {
  return `rosto-slot-${slot}`;
}

/**
 * Makes a slot this tab's. Where the browser has no locks, or does not answer, it is so without one: whoever writes makes sure
 * that no other tab has.
 *
 * @param {string} slot
 * @returns {Promise<(() => void) | undefined>} lets go of it; nothing if another tab holds it
 */
export function hold(slot) {
  return new Promise((resolve) => {
    let isLate = false;
    const giveUp = async () => {
      isLate = true;
      resolve((await heldOf([slot])).has(slot) ? undefined : () => {});
    };
    setTimeout(giveUp, PATIENCE_MS);
    const keep = () => isLate || new Promise((letGo) => resolve(() => letGo(undefined)));
    Promise.resolve().then(() => navigator.locks.request(lockOf(slot), keep)).catch(giveUp);
  });
}

/**
 * Those of the slots that a tab holds, this one or another; none where the browser does not say.
 *
 * @param {string[]} slots
 */
export async function heldOf(slots) {
  try {
    const { held = [] } = await within(QUERY_MS, navigator.locks.query(), "looking for locks");
    const names = new Set(held.map(({ name }) => name));
    return new Set(slots.filter((slot) => names.has(lockOf(slot))));
  } catch {
    return new Set();
  }
}
