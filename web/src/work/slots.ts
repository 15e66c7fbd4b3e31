/** Saved work in the database. Each open face has one slot, written only by the tab that holds its lock. */

import { ORDER, resultOf, transact } from "./database.ts";
import { deleteDraft, deleteOtherDrafts, readDraft, nextOrder } from "./drafts.ts";
import { filesWith } from "./face.ts";
import { lockedSlots, lockSlot } from "./locks.ts";
import { isFaceRow, isWorkRow } from "./row-checks.ts";
import { TimeoutError } from "./timeout.ts";
import type { Face, SourceFile } from "./face.ts";
import type { FaceRow, Work } from "./row-checks.ts";

export type Slot = { slot: string; order: number; isComplete: boolean; isLocked: boolean; };

export interface SlotWrite {
  face: Pick<Face, "name" | "files">;
  work: Work;
  /** whether this tab has already written the face */
  isFaceStored: boolean;
  /** save order of the slot when this tab last wrote or read it */
  since?: number;
}

/** Number of slots to keep that no tab has open. */
const MAX_FREE_SLOTS = 6;

/** Numbers sort before keys of other types. */
const NUMBERS = () => IDBKeyRange.upperBound(Number.MAX_SAFE_INTEGER);

/** Thrown if another tab has written a slot since this one did. */
export class SlotConflict extends Error {}

/** Thrown if a row of a slot is missing or invalid. */
export class CorruptSlot extends Error {}

/** Lists the slots, latest first. Reads only keys, so that an unreadable row does not hide the other slots. */
export async function allSlots(): Promise<Slot[]> {
  const [faces, edits, orders] = await transact("readonly", (stores) => Promise.all([keysOf(stores.faces), keysOf(stores.done), ordersIn(stores.done)]));
  const names = [...new Set([...faces, ...edits])];
  const locked = await lockedSlots(names);
  const slots = names.map((slot) => ({
    slot,
    order: Math.max(orders.get(slot) ?? 0, readDraft(slot)?.order ?? 0),
    isComplete: faces.includes(slot) && edits.includes(slot),
    isLocked: locked.has(slot),
  }));
  return slots.sort((one, other) => other.order - one.order);
}

/**
 * Reads the face in a slot, with the save order of its database row. A newer draft replaces the row's work if the
 * stored files contain the draft's pictures.
 */
export async function readSlot(slot: string): Promise<{ face: Face; order: number; }> {
  const [row, done] = await transact("readonly", (stores) => Promise.all([resultOf(stores.faces.get(slot)), resultOf(stores.done.get(slot))]));
  if (!isFaceRow(row)) throw new CorruptSlot(`face of slot ${slot}`);
  if (!isWorkRow(done)) throw new CorruptSlot(`work of slot ${slot}`);
  const files = await Promise.all(row.files.map(readable));
  const draft = readDraft(slot);
  const isNewer = draft && draft.order > done.order && draft.pictures.every((picture) => filesWith(files, [picture]).length === 1);
  const { order: _, ...work } = isNewer ? draft : done;
  return { face: { name: row.name, files, ...work }, order: done.order };
}

/**
 * Writes a face and its edits in one transaction.
 *
 * @returns the new save order
 */
export async function writeSlot(slot: string, content: SlotWrite): Promise<number> {
  const { name, files } = content.face;
  const order = await put(slot, content, { name, files }).catch(async (error) => {
    if (error instanceof TimeoutError || error instanceof SlotConflict) throw error;
    return put(slot, content, { name, files: await Promise.all(files.map(asBytes)) });
  });
  if ((readDraft(slot)?.order ?? Infinity) <= order) deleteDraft(slot);
  return order;
}

/** Deletes the oldest slots that no tab has open. */
export async function prune() {
  const slots = await allSlots();
  const free = slots.filter(({ isLocked }) => !isLocked);
  for (const { slot } of free.slice(MAX_FREE_SLOTS)) await deleteIfFree(slot);
  deleteOtherDrafts(slots.map(({ slot }) => slot));
}

function put(slot: string, { work, isFaceStored, since }: SlotWrite, row: FaceRow) {
  return transact("readwrite", async (stores) => {
    const [key, previous, latest] = await Promise.all([resultOf(stores.faces.getKey(slot)), resultOf(stores.done.get(slot)), latestOrder(stores.done)]);
    if (previous && previous.order !== since) throw new SlotConflict(`slot ${slot}`);
    const order = nextOrder(latest);
    // The browser or the user may have cleared the database meanwhile.
    const exists = isFaceStored && key !== undefined;
    const putFace = exists ? [] : [resultOf(stores.faces.put(row, slot))];
    await Promise.all([...putFace, resultOf(stores.done.put({ ...work, order }, slot))]);
    return order;
  });
}

/** Fallback if the browser rejects Blobs, as in some private windows. */
async function asBytes({ file, ...source }: SourceFile) {
  return { ...source, file: await file.arrayBuffer() };
}

/** Throws if the file can no longer be read. */
async function readable({ file, ...source }: FaceRow["files"][number]) {
  const blob = new Blob([file]);
  await blob.slice(0, 1).arrayBuffer();
  return { ...source, file: blob };
}

async function deleteIfFree(slot: string) {
  const release = await lockSlot(slot);
  if (!release) return;
  try {
    await transact("readwrite", (stores) => Promise.all([resultOf(stores.faces.delete(slot)), resultOf(stores.done.delete(slot))]));
    deleteDraft(slot);
  } finally {
    release();
  }
}

async function keysOf(store: IDBObjectStore) {
  return (await resultOf(store.getAllKeys())).map(String);
}

/** Save order by slot. */
function ordersIn(done: IDBObjectStore): Promise<Map<string, number>> {
  const orders = new Map();
  const request = done.index(ORDER).openKeyCursor(NUMBERS());
  return new Promise((resolve, reject) => {
    request.onerror = () => reject(request.error);
    request.onsuccess = () => {
      const { result: cursor } = request;
      if (!cursor) return resolve(orders);
      orders.set(String(cursor.primaryKey), cursor.key);
      cursor.continue();
    };
  });
}

async function latestOrder(done: IDBObjectStore) {
  const cursor = await resultOf(done.index(ORDER).openKeyCursor(NUMBERS(), "prev"));
  return cursor ? Number(cursor.key) : undefined;
}
