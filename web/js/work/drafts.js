/**
 * Drafts in local storage: while a page unloads, there is no time for an asynchronous database write. The save order is
 * kept here too, shared by all tabs; it is a counter because clocks can go back.
 *
 * @typedef {import("./row-checks.js").Work} Work
 * @typedef {import("./row-checks.js").StoredWork} StoredWork
 */
import { isWorkRow } from "./row-checks.js";

const PREFIX = "rosto-drafts-";
const ORDER = "rosto-order";

/**
 * Increments the save order.
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
 * @param {Work} work
 */
export function writeDraft(slot, work) {
  write(PREFIX + slot, JSON.stringify({ ...work, order: nextOrder() }));
}

/**
 * @param {string} slot
 * @returns {StoredWork | undefined} undefined if there is no valid draft
 */
export function readDraft(slot) {
  try {
    const draft = JSON.parse(read(PREFIX + slot) ?? "null");
    return isWorkRow(draft) ? draft : undefined;
  } catch {
    return undefined;
  }
}

/** @param {string} slot */
export function deleteDraft(slot) {
  try {
    localStorage.removeItem(PREFIX + slot);
  } catch {
    // Storage is blocked, so there is no draft.
  }
}

/** Deletes the drafts of slots that no longer exist. @param {string[]} slots that exist */
export function deleteOtherDrafts(slots) {
  try {
    const drafted = Object.keys(localStorage).filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length));
    for (const slot of drafted) if (!slots.includes(slot)) deleteDraft(slot);
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
    // Blocked or full: only the changes since the last database write are lost.
  }
}
