/** Saved work. Each open face has one slot in the database, written only by the tab that holds its lock. */

import { attempt, TimeoutError, transact, withTimeout } from "./database.ts";
import { filesWith, viewsOf } from "./face.ts";
import type { FaceRow, Work, WorkRow } from "./database.ts";
import type { Face, SourceFile } from "./face.ts";

/** State of a slot when this tab last wrote or read it. */
export interface Stored {
  order: number;
  files: SourceFile[];
}

/** Time for files to be stored: full-size photos can amount to hundreds of megabytes. */
const STORE_FILES_MS = 20_000;

/** Number of slots to keep that no tab has open. */
const MAX_FREE_SLOTS = 6;

/** Time to wait for the lock of a page that is just being left. */
const LOCK_MS = 1000;
const QUERY_MS = 2000;

/** Keys in local storage. Drafts are written while a page unloads, when there is no time for a database. */
const DRAFT = "rosto-drafts-";
const ORDER = "rosto-order";

/** Slots of the locks that this tab holds, by their release functions. A busy browser ends a lock after its release. */
const ownLocks = new Map<() => void, string>();

/** Highest save order known to this tab. */
let latest = 0;

/** Thrown if another tab has written a slot since this one did. */
export class SlotConflict extends Error {}

/** Lists the slots, latest first. Does not read the faces, so that an unreadable one does not hide the others. */
export async function listSlots() {
  const [faces, slots, works] = await transact("readonly", (transaction) => {
    const byOrder = transaction.objectStore("done").index("order");
    const numbers = IDBKeyRange.upperBound(Number.MAX_SAFE_INTEGER);
    return Promise.all([
      transaction.objectStore("faces").getAllKeys(),
      byOrder.getAllKeys(numbers),
      byOrder.getAll(numbers),
    ]);
  });
  const locked = await lockedAmong(slots);
  const listed = slots.map((slot, index) => {
    const order = Math.max(works[index]?.order ?? 0, draftOf(slot)?.order ?? 0);
    return { slot, order, isLocked: locked.has(slot) };
  });
  latest = Math.max(latest, ...listed.map(({ order }) => order));
  return listed.filter(({ slot }) => faces.includes(slot)).sort((one, other) => other.order - one.order);
}

/**
 * Reads the face in a slot. A newer draft replaces the row's work if the stored files contain the draft's pictures.
 * Throws if a row is missing or damaged.
 */
export async function readSlot(slot: string): Promise<{ face: Face; stored: Stored }> {
  const [row, done] = await transact("readonly", (transaction) =>
    Promise.all([transaction.objectStore("faces").get(slot), transaction.objectStore("done").get(slot)]));
  if (typeof row?.name !== "string") throw new Error(`damaged face in slot ${slot}`);
  const files = await Promise.all(row.files.map(readable));
  if (!isWork(done, files)) throw new Error(`damaged work in slot ${slot}`);
  const draft = draftOf(slot);
  const isNewer = draft && draft.order > done.order && isWork(draft, files);
  const { order: _, ...work } = isNewer ? draft : done;
  return { face: { name: row.name, files, ...work }, stored: { order: done.order, files } };
}

/**
 * Writes a face and its edits in one transaction.
 *
 * @param stored undefined for a new slot, which no other tab knows; so its rows are sent to the browser in this task
 * @returns the new save order
 */
export async function writeSlot(slot: string, { name, files }: Face, work: Work, stored: Stored | undefined) {
  const write = (row: FaceRow) => transact("readwrite", async (transaction) => {
    const [faces, done] = [transaction.objectStore("faces"), transaction.objectStore("done")];
    const [key, previous] = stored ? await Promise.all([faces.getKey(slot), done.get(slot)]) : [];
    if (previous && previous.order !== stored?.order) throw new SlotConflict(`slot ${slot}`);
    const order = nextOrder();
    // The browser or the user may have cleared the database meanwhile. The face is put first: WebKit's private windows
    // refuse blobs, and block the database if another request is pending before the refused one.
    const isFaceStored = key !== undefined && stored?.files === files;
    const puts = [...(isFaceStored ? [] : [faces.put(row, slot)]), done.put({ ...work, order }, slot)];
    // Also completes if the page is left now.
    if (!stored) transaction.commit();
    await Promise.all(puts);
    return order;
  }, stored?.files === files ? undefined : STORE_FILES_MS);
  const order = await write({ name, files }).catch(async (error) => {
    if (error instanceof TimeoutError || error instanceof SlotConflict) throw error;
    // The browser may refuse blobs, as in some private windows.
    return write({ name, files: await Promise.all(files.map(withBytes)) });
  });
  if ((draftOf(slot)?.order ?? Infinity) <= order) attempt(() => localStorage.removeItem(DRAFT + slot));
  return order;
}

/** Deletes the oldest slots that no tab has open, and drafts without a slot. */
export async function prune() {
  const slots = await listSlots();
  for (const { slot } of slots.filter(({ isLocked }) => !isLocked).slice(MAX_FREE_SLOTS)) {
    const release = await lockSlot(slot);
    if (!release) continue;
    const remove = transact("readwrite", (transaction) =>
      Promise.all([transaction.objectStore("faces").delete(slot), transaction.objectStore("done").delete(slot)]));
    await remove.finally(release);
  }
  const keys = new Set(slots.map(({ slot }) => DRAFT + slot));
  attempt(() => {
    for (const key of Object.keys(localStorage)) {
      if (key.startsWith(DRAFT) && !keys.has(key)) localStorage.removeItem(key);
    }
  });
}

/** Writes edits at once. If storage is blocked or full, only changes since the last database write are lost. */
export function writeDraft(slot: string, work: Work) {
  attempt(() => localStorage.setItem(DRAFT + slot, JSON.stringify({ ...work, order: nextOrder() })));
}

/**
 * Locks a slot for this tab. If the browser has no locks or does not answer, the tab proceeds without one; writes still
 * detect a conflict with another tab.
 *
 * @returns the release function; undefined if another tab holds the slot
 */
export async function lockSlot(slot: string) {
  const controller = new AbortController();
  let own: (() => void) | undefined;
  const granted = new Promise<() => void>((resolve, reject) => {
    const hold = () => new Promise<void>((release) => {
      own = release;
      ownLocks.set(release, slot);
      resolve(release);
    });
    const request = async () => navigator.locks.request(lockOf(slot), { signal: controller.signal }, hold);
    request().catch(reject).finally(() => own && ownLocks.delete(own));
  });
  const releaseOnceGranted = () => void granted.then((release) => release()).catch(() => {});
  return withTimeout(LOCK_MS, granted, "locking a slot").catch(async () => {
    // The new lock follows once the browser has ended the earlier one.
    if ([...ownLocks.values()].includes(slot)) return releaseOnceGranted;
    controller.abort();
    const isHeld = await isSlotLocked(slot);
    // A busy browser may have granted it after the limit.
    return own ?? (isHeld ? undefined : () => {});
  });
}

/** Whether a tab holds a slot; false if the browser does not answer. */
export async function isSlotLocked(slot: string) {
  return (await lockedAmong([slot])).has(slot);
}

/** The slots that a tab holds, this one included; empty if the browser does not answer. */
async function lockedAmong(slots: string[]) {
  try {
    const { held = [] } = await withTimeout(QUERY_MS, navigator.locks.query(), "querying the locks");
    const names = new Set(held.map(({ name }) => name));
    return new Set(slots.filter((slot) => names.has(lockOf(slot))));
  } catch {
    return new Set<string>();
  }
}

function lockOf(slot: string) {
  return `rosto-slot-${slot}`;
}

/** Increments the save order, which all tabs share. It is a counter because clocks can go back. */
function nextOrder() {
  latest = Math.max(latest, Number(attempt(() => localStorage.getItem(ORDER))) || 0) + 1;
  attempt(() => localStorage.setItem(ORDER, String(latest)));
  return latest;
}

/** The draft of a slot, unchecked apart from its order. */
function draftOf(slot: string): WorkRow | undefined {
  const draft = attempt(() => JSON.parse(localStorage.getItem(DRAFT + slot) ?? "null"));
  return Number.isSafeInteger(draft?.order) ? draft : undefined;
}

/** Whether a row is complete, of this version, and its pictures are in the files. */
function isWork(row: WorkRow | undefined, files: SourceFile[]): row is WorkRow {
  const isSound = attempt(() => {
    const { photos, pictures, lead, edits, preferences, order } = row as WorkRow;
    const areFound = pictures.every((picture) => filesWith(files, [picture]).length === 1);
    const hasTexts = typeof edits === "string" && JSON.parse(edits) && typeof preferences === "string";
    return areFound && hasTexts && typeof pictures[lead] === "string" && viewsOf(photos).length === pictures.length
      && Number.isSafeInteger(order);
  });
  return Boolean(isSound);
}

/** Throws if the file can no longer be read. */
async function readable({ file, ...source }: FaceRow["files"][number]) {
  if (!(file instanceof Blob || file instanceof ArrayBuffer)) throw new Error("damaged file");
  const blob = new Blob([file]);
  await blob.slice(0, 1).arrayBuffer();
  return { ...source, file: blob };
}

async function withBytes({ file, ...source }: SourceFile) {
  return { ...source, file: await file.arrayBuffer() };
}
