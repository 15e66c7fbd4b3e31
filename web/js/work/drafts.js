/**
 * What a page that is being left has no time to give to the database. It is in the browser's local storage, and so is the
 * order of what was kept last, by any tab: clocks can be set back.
 *
 * @typedef {import("./work.js").Done} Done
 * @typedef {Done & { order: number }} KeptDone `order`: greater than that of all that was kept before
 */
import { isDone } from "./whole.js";

const PREFIX = "rosto-drafts-";
const ORDER = "rosto-order";

/**
 * The next order.
 *
 * @param {number} [latest] in the database
 */
export function nextOrder(latest = 0) {
  const order = Math.max(latest, Number(read(ORDER)) || 0) + 1;
  write(ORDER, String(order));
  return order;
}

/**
 * @param {string} slot
 * @param {Done} done
 */
export function writeDraft(slot, done) {
  write(PREFIX + slot, JSON.stringify({ ...done, order: nextOrder() }));
}

/**
 * @param {string} slot
 * @returns {KeptDone | undefined} nothing where there are none that can be read
 */
export function readDraft(slot) {
  try {
    const words = JSON.parse(read(PREFIX + slot) ?? "null");
    return isDone(words) ? words : undefined;
  } catch {
    return undefined;
  }
}

/** @param {string} slot */
export function deleteDraft(slot) {
  try {
    localStorage.removeItem(PREFIX + slot);
  } catch {
    // There was nothing to forget, then.
  }
}

/** Forgets those of other slots, whose face was never kept or is gone. @param {string[]} slots */
export function deleteOtherDrafts(slots) {
  try {
    const spoken = Object.keys(localStorage).filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length));
    for (const slot of spoken) if (!slots.includes(slot)) deleteDraft(slot);
  } catch {
    // As above.
  }
}

/** @param {string} key */
function read(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** @param {string} key @param {string} value */
function write(key, value) {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Blocked or full: the database has all but the last moment.
  }
}
