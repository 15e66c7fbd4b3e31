/**
 * Saved work in the database. Each open face has one slot, written only by the tab that holds its lock.
 *
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").EditState} EditState
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("./database.js").Stores} Stores
 * @typedef {import("./row-checks.js").StoredPhoto} StoredPhoto
 * @typedef {{ slot: string, order: number, isComplete: boolean, isLocked: boolean }} Slot
 *
 * @typedef {object} SlotWrite
 * @property {OpenedFace} face
 * @property {EditState} edits
 * @property {boolean} isFaceStored whether this tab has already written the face
 * @property {number} [since] save order of the slot when this tab last wrote or read it
 */
import { ORDER, resultOf, transact } from "./database.js";
import { deleteDraft, deleteOtherDrafts, readDraft, nextOrder } from "./drafts.js";
import { lockedSlots, lockSlot } from "./locks.js";
import { isEditRow, isFaceRow } from "./row-checks.js";
import { TimeoutError } from "./timeout.js";

/** Number of slots to keep that no tab has open. */
const MAX_FREE_SLOTS = 6;

/** Numbers sort before keys of other types. */
const NUMBERS = () => IDBKeyRange.upperBound(Number.MAX_SAFE_INTEGER);

/** Thrown if another tab has written a slot since this one did. */
export class SlotConflict extends Error {}

/** Thrown if a row of a slot is missing or invalid. */
export class CorruptSlot extends Error {}

/**
 * Lists the slots, latest first. Reads only keys, so that an unreadable row does not hide the other slots.
 *
 * @returns {Promise<Slot[]>}
 */
export async function allSlots() {
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
 * Reads the work in a slot, with the save order of its database row. A newer draft replaces the edits of the row.
 *
 * @param {string} slot
 * @returns {Promise<{ work: Work, order: number }>}
 */
export async function readSlot(slot) {
  const [face, row] = await transact("readonly", (stores) => Promise.all([resultOf(stores.faces.get(slot)), resultOf(stores.done.get(slot))]));
  if (!isFaceRow(face)) throw new CorruptSlot(`face of slot ${slot}`);
  if (!isEditRow(row)) throw new CorruptSlot(`edits of slot ${slot}`);
  const draft = readDraft(slot);
  const { order: _, ...edits } = draft && draft.order > row.order ? draft : row;
  const { further, ...lead } = face;
  const photos = further && (await Promise.all(further.map(readPhoto)));
  return { work: { face: { ...(await readPhoto(lead)), ...(photos && { further: photos }) }, ...edits }, order: row.order };
}

/**
 * Writes a face and its edits in one transaction.
 *
 * @param {string} slot
 * @param {SlotWrite} content
 * @returns {Promise<number>} the new save order
 */
export async function writeSlot(slot, content) {
  const order = await put(slot, content, asBlob).catch((error) => {
    if (error instanceof TimeoutError || error instanceof SlotConflict) throw error;
    return put(slot, content, withoutFile);
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

/**
 * @param {string} slot
 * @param {SlotWrite} content
 * @param {(photo: OpenedFace) => object} asStored
 */
function put(slot, { face, edits, isFaceStored, since }, asStored) {
  return transact("readwrite", async (stores) => {
    const [key, previous, latest] = await Promise.all([resultOf(stores.faces.getKey(slot)), resultOf(stores.done.get(slot)), latestOrder(stores.done)]);
    if (previous && previous.order !== since) throw new SlotConflict(`slot ${slot}`);
    const order = nextOrder(latest);
    const further = face.further?.map(asStored);
    // The browser or the user may have cleared the database meanwhile.
    const exists = isFaceStored && key !== undefined;
    const putFace = exists ? [] : [resultOf(stores.faces.put({ ...asStored(face), ...(further && { further }) }, slot))];
    await Promise.all([...putFace, resultOf(stores.done.put({ ...edits, order }, slot))]);
    return order;
  });
}

/**
 * Stores the pixels as a Blob, which the browser writes off the main thread.
 *
 * @param {OpenedFace} photo
 */
function asBlob(photo) {
  return { ...photo, picture: new Blob([/** @type {BlobPart} */ (photo.picture)]) };
}

/** Fallback if the browser rejects Blobs, as in some private windows, or the disk is full. @param {OpenedFace} photo */
function withoutFile({ photo: _, ...photo }) {
  return photo;
}

/**
 * Reads a photo's pixels; drops its original file if that is no longer readable.
 *
 * @param {StoredPhoto} stored
 * @returns {Promise<OpenedFace>}
 */
async function readPhoto({ photo: file, picture, ...found }) {
  const pixels = picture instanceof Blob ? new Uint8Array(await picture.arrayBuffer()) : picture;
  const isReadable = file && (await file.slice(0, 1).arrayBuffer().then(() => true, () => false));
  return { ...found, ...(isReadable && { photo: file }), picture: pixels };
}

/** @param {string} slot */
async function deleteIfFree(slot) {
  const release = await lockSlot(slot);
  if (!release) return;
  try {
    await transact("readwrite", (stores) => Promise.all([resultOf(stores.faces.delete(slot)), resultOf(stores.done.delete(slot))]));
    deleteDraft(slot);
  } finally {
    release();
  }
}

/** @param {IDBObjectStore} store */
async function keysOf(store) {
  return (await resultOf(store.getAllKeys())).map(String);
}

/**
 * Save order by slot.
 *
 * @param {IDBObjectStore} done
 * @returns {Promise<Map<string, number>>}
 */
function ordersIn(done) {
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

/** @param {IDBObjectStore} done */
async function latestOrder(done) {
  const cursor = await resultOf(done.index(ORDER).openKeyCursor(NUMBERS(), "prev"));
  return cursor ? Number(cursor.key) : undefined;
}
