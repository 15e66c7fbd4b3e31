/**
 * The works kept in this browser: each open face has a slot of its own, which only the tab that holds it writes.
 *
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {import("./database.js").Stores} Stores
 * @typedef {import("./whole.js").KeptPhoto} KeptPhoto
 * @typedef {{ slot: string, order: number, isWhole: boolean, isHeld: boolean }} Slot
 *
 * @typedef {object} Keeping
 * @property {OpenedFace} face
 * @property {Done} done
 * @property {boolean} isFaceKept whether the slot has this face, as far as this tab knows
 * @property {number} [since] the order of what this tab last kept in the slot or read there
 */
import { ORDER, answer, transact } from "./database.js";
import { deleteDraft, deleteOtherDrafts, readDraft, nextOrder } from "./drafts.js";
import { heldOf, hold } from "./locks.js";
import { isDone, isFace } from "./whole.js";
import { Late } from "./within.js";

/** As many works as this are kept that no tab has open. */
const MOST_KEPT = 6;

/** Numbers come before all other keys. */
const NUMBERS = () => IDBKeyRange.upperBound(Number.MAX_SAFE_INTEGER);

/** Thrown where another tab has written to a slot since this one did. */
export class Taken extends Error {}

/** Thrown where a slot's rows are not all there, or not what they should be. */
export class Damaged extends Error {}

/**
 * The slots, the latest first. Of their rows only the keys are read: one that cannot be read hides no other.
 *
 * @returns {Promise<Slot[]>}
 */
export async function allSlots() {
  const [faces, done, orders] = await transact("readonly", (stores) => Promise.all([keysOf(stores.faces), keysOf(stores.done), ordersIn(stores.done)]));
  const names = [...new Set([...faces, ...done])];
  const held = await heldOf(names);
  const slots = names.map((slot) => ({
    slot,
    order: Math.max(orders.get(slot) ?? 0, readDraft(slot)?.order ?? 0),
    isWhole: faces.includes(slot) && done.includes(slot),
    isHeld: held.has(slot),
  }));
  return slots.sort((one, other) => other.order - one.order);
}

/**
 * The work in a slot, and the order of what the database has of it.
 *
 * @param {string} slot
 * @returns {Promise<{ work: Work, order: number }>}
 */
export async function workIn(slot) {
  const [face, done] = await transact("readonly", (stores) => Promise.all([answer(stores.faces.get(slot)), answer(stores.done.get(slot))]));
  if (!isFace(face)) throw new Damaged(`the face in ${slot}`);
  if (!isDone(done)) throw new Damaged(`what was done in ${slot}`);
  const latest = readDraft(slot);
  const { order: _, ...left } = latest && latest.order > done.order ? latest : done;
  const { further, ...lead } = face;
  const photos = further && (await Promise.all(further.map(readPhoto)));
  return { work: { face: { ...(await readPhoto(lead)), ...(photos && { further: photos }) }, ...left }, order: done.order };
}

/**
 * Keeps a face and what was done to it: both or neither.
 *
 * @param {string} slot
 * @param {Keeping} keeping
 * @returns {Promise<number>} the order of what was kept
 */
export async function keep(slot, keeping) {
  const order = await put(slot, keeping, asBlob).catch((error) => {
    if (error instanceof Late || error instanceof Taken) throw error;
    return put(slot, keeping, withoutFile);
  });
  if ((readDraft(slot)?.order ?? Infinity) <= order) deleteDraft(slot);
  return order;
}

/** Forgets the oldest of the works that no tab has open. */
export async function prune() {
  const slots = await allSlots();
  const free = slots.filter(({ isHeld }) => !isHeld);
  for (const { slot } of free.slice(MOST_KEPT)) await dropIfFree(slot);
  deleteOtherDrafts(slots.map(({ slot }) => slot));
}

/**
 * @param {string} slot
 * @param {Keeping} keeping
 * @param {(photo: OpenedFace) => object} asKept
 */
function put(slot, { face, done, isFaceKept, since }, asKept) {
  return transact("readwrite", async (stores) => {
    const [key, before, latest] = await Promise.all([answer(stores.faces.getKey(slot)), answer(stores.done.get(slot)), latestOrder(stores.done)]);
    if (before && before.order !== since) throw new Taken(`slot ${slot}`);
    const order = nextOrder(latest);
    const further = face.further?.map(asKept);
    // The browser or the visitor may have cleared the database meanwhile.
    const isThere = isFaceKept && key !== undefined;
    const putting = isThere ? [] : [answer(stores.faces.put({ ...asKept(face), ...(further && { further }) }, slot))];
    await Promise.all([...putting, answer(stores.done.put({ ...done, order }, slot))]);
    return order;
  });
}

/**
 * As a blob the pixels are handed to the database outside the page's own thread.
 *
 * @param {OpenedFace} photo
 */
function asBlob(photo) {
  return { ...photo, picture: new Blob([/** @type {BlobPart} */ (photo.picture)]) };
}

/** Not every browser takes blobs in a private window, or has room for the photo's own file. @param {OpenedFace} photo */
function withoutFile({ photo: _, ...photo }) {
  return photo;
}

/**
 * A photo with its pixels, as it was kept. Where its file alone cannot be read, it comes without.
 *
 * @param {KeptPhoto} kept
 * @returns {Promise<OpenedFace>}
 */
async function readPhoto({ photo: file, picture, ...found }) {
  const pixels = picture instanceof Blob ? new Uint8Array(await picture.arrayBuffer()) : picture;
  const isReadable = file && (await file.slice(0, 1).arrayBuffer().then(() => true, () => false));
  return { ...found, ...(isReadable && { photo: file }), picture: pixels };
}

/** @param {string} slot is dropped unless a tab holds it */
async function dropIfFree(slot) {
  const letGo = await hold(slot);
  if (!letGo) return;
  try {
    await transact("readwrite", (stores) => Promise.all([answer(stores.faces.delete(slot)), answer(stores.done.delete(slot))]));
    deleteDraft(slot);
  } finally {
    letGo();
  }
}

/** @param {IDBObjectStore} store */
async function keysOf(store) {
  return (await answer(store.getAllKeys())).map(String);
}

/**
 * The order of each slot that has one.
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
  const cursor = await answer(done.index(ORDER).openKeyCursor(NUMBERS(), "prev"));
  return cursor ? Number(cursor.key) : undefined;
}
