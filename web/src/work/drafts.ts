/**
 * Drafts in local storage: while a page unloads, there is no time for an asynchronous database write. The save order is
 * kept here too, shared by all tabs; it is a counter because clocks can go back.
 */

import { isWorkRow } from "./row-checks.ts";
import type { StoredWork, Work } from "./row-checks.ts";

const PREFIX = "rosto-drafts-";
const ORDER = "rosto-order";

/**
 * Increments the save order.
 *
 * @param latest in the database
 */
export function nextOrder(latest: number = 0) {
  const order = Math.max(latest, Number(read(ORDER)) || 0) + 1;
  write(ORDER, String(order));
  return order;
}

export function writeDraft(slot: string, work: Work) {
  write(PREFIX + slot, JSON.stringify({ ...work, order: nextOrder() }));
}

/** @returns undefined if there is no valid draft */
export function readDraft(slot: string): StoredWork | undefined {
  try {
    const draft = JSON.parse(read(PREFIX + slot) ?? "null");
    return isWorkRow(draft) ? draft : undefined;
  } catch {
    return undefined;
  }
}

export function deleteDraft(slot: string) {
  try {
    localStorage.removeItem(PREFIX + slot);
  } catch {
    // Storage is blocked, so there is no draft.
  }
}

/** Deletes the drafts of slots that no longer exist. @param slots that exist */
export function deleteOtherDrafts(slots: string[]) {
  try {
    const drafted = Object.keys(localStorage).filter((key) => key.startsWith(PREFIX)).map((key) => key.slice(PREFIX.length));
    for (const slot of drafted) if (!slots.includes(slot)) deleteDraft(slot);
  } catch {
    // As above.
  }
}

function read(key: string) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

function write(key: string, value: string) {
  try {
    localStorage.setItem(key, value);
  } catch {
    // Blocked or full: only the changes since the last database write are lost.
  }
}
