/**
 * The works kept in this browser: each open face has a slot of its own, which only the tab that holds it writes.
 *
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("./work.js").Done} Done
 * @typedef {import("./work.js").OpenedFace} OpenedFace
 * @typedef {Done & { at: number }} KeptDone `at`: when, in ms since 1970
 */

const DATABASE = "rosto";
const VERSION = 2;
/** The picture and landmarks of each slot, and what was done, which changes often. */
const FACES = "faces";
const DONE = "done";
/** What the first version kept, of one face alone. */
const EARLIER = "work";

/** As many works as this are kept that no tab has open. */
const MOST_KEPT = 6;

/** @param {string} slot */
export function lockOf(slot) {
  return `rosto-slot-${slot}`;
}

/** The slots that have a face and that no tab holds, the latest first. */
export async function freeSlots() {
  const faces = new Set(await result((await open(FACES, "readonly")).getAllKeys()));
  const store = await open(DONE, "readonly");
  const [names, done] = await Promise.all([result(store.getAllKeys()), result(store.getAll())]);
  const { held = [] } = await navigator.locks.query();
  const isHeld = new Set(held.map(({ name }) => name));
  const slots = names.map((name, place) => ({ slot: String(name), at: Math.max(done[place]?.at ?? 0, lastWords(String(name))?.at ?? 0) }));
  const free = slots.filter(({ slot }) => faces.has(slot) && !isHeld.has(lockOf(slot)));
  return free.sort((one, other) => other.at - one.at).map(({ slot }) => slot);
}

/**
 * The work in a slot; nothing where there is none.
 *
 * @param {string} slot
 * @returns {Promise<Work | undefined>}
 */
export async function workIn(slot) {
  const face = await result((await open(FACES, "readonly")).get(slot));
  /** @type {KeptDone | undefined} */
  const done = await result((await open(DONE, "readonly")).get(slot));
  if (!face || !done) return undefined;
  const read = await readPhoto(face);
  const further = face.further && (await Promise.all(face.further.map(readPhoto)));
  const latest = lastWords(slot);
  return { face: { ...read, ...(further && { further }) }, ...(latest && latest.at > done.at ? latest : done) };
}

/**
 * Keeps an opened face unless it is there already; what is done to it comes later. The slot that it was reopened from is
 * then of no more use.
 *
 * @param {string} slot
 * @param {OpenedFace} face
 * @param {string} [reopenedFrom]
 */
export async function settle(slot, face, reopenedFrom) {
  const isThere = (await result((await open(FACES, "readonly")).getKey(slot))) !== undefined;
  if (!isThere) await keepFace(slot, face);
  if (reopenedFrom !== undefined) await dropIfFree(reopenedFrom);
}

/**
 * Keeps a face with its photos, in place of what the slot had.
 *
 * @param {string} slot
 * @param {OpenedFace} face
 */
export async function keepFace(slot, face) {
  const put = async (/** @type {(photo: OpenedFace) => object} */ kept) => {
    const further = face.further?.map(kept);
    return result((await open(FACES, "readwrite")).put({ ...kept(face), ...(further && { further }) }, slot));
  };
  // As a blob the pixels are handed to the database outside the page's own thread; not every browser takes blobs in a
  // private window: there the photo's own file stays behind.
  const asBlob = (/** @type {OpenedFace} */ photo) => ({ ...photo, picture: new Blob([/** @type {BlobPart} */ (photo.picture)]) });
  const withoutFile = (/** @type {OpenedFace} */ { photo: _, ...photo }) => photo;
  await put(asBlob).catch(() => put(withoutFile));
}

/**
 * A photo with its pixels, as it was kept.
 *
 * @param {OpenedFace & { picture: Uint8Array | Blob }} photo
 * @returns {Promise<OpenedFace>}
 */
async function readPhoto(photo) {
  const { picture } = photo;
  return picture instanceof Blob ? { ...photo, picture: new Uint8Array(await picture.arrayBuffer()) } : photo;
}

/**
 * @param {string} slot
 * @param {Done} done
 */
export async function keepDone(slot, done) {
  const at = Date.now();
  await result((await open(DONE, "readwrite")).put({ ...done, at }, slot));
  const latest = lastWords(slot);
  if (latest && latest.at <= at) forgetLastWords(slot);
}

/**
 * What a page that is being left has no time to give to the database.
 *
 * @param {string} slot
 * @param {Done} done
 */
export function keepLastWords(slot, done) {
  try {
    localStorage.setItem(lockOf(slot), JSON.stringify({ ...done, at: Date.now() }));
  } catch {
    // Blocked or full: the database has all but the last moment.
  }
}

/** Forgets the oldest of the works that no tab has open. */
export async function prune() {
  for (const slot of (await freeSlots()).slice(MOST_KEPT)) await dropIfFree(slot);
}

/** @param {string} slot is dropped unless a tab holds it */
async function dropIfFree(slot) {
  await navigator.locks.request(lockOf(slot), { ifAvailable: true }, async (lock) => {
    if (lock) await drop(slot);
  });
}

/** @param {string} slot */
async function drop(slot) {
  forgetLastWords(slot);
  await result((await open(FACES, "readwrite")).delete(slot));
  await result((await open(DONE, "readwrite")).delete(slot));
}

/**
 * @param {string} slot
 * @returns {KeptDone | undefined}
 */
function lastWords(slot) {
  try {
    return JSON.parse(localStorage.getItem(lockOf(slot)) ?? "null") ?? undefined;
  } catch {
    return undefined;
  }
}

/** @param {string} slot */
function forgetLastWords(slot) {
  try {
    localStorage.removeItem(lockOf(slot));
  } catch {
    // There was nothing to forget, then.
  }
}

/**
 * @param {typeof FACES | typeof DONE} store
 * @param {IDBTransactionMode} mode
 */
async function open(store, mode) {
  const request = indexedDB.open(DATABASE, VERSION);
  request.onupgradeneeded = () => upgrade(request);
  const database = await result(request);
  // A page of another version may want the database for itself.
  database.onversionchange = () => database.close();
  const transaction = database.transaction(store, mode);
  const close = () => database.close();
  transaction.oncomplete = close;
  transaction.onabort = close;
  return transaction.objectStore(store);
}

/** @param {IDBOpenDBRequest} request */
function upgrade({ result: database, transaction }) {
  const [faces, done] = [database.createObjectStore(FACES), database.createObjectStore(DONE)];
  if (!transaction || !database.objectStoreNames.contains(EARLIER)) return;
  const earlier = transaction.objectStore(EARLIER);
  earlier.get("face").onsuccess = ({ target }) => keepIfThere(faces, target);
  const edits = earlier.get("edits");
  edits.onsuccess = ({ target }) => {
    keepIfThere(done, target);
    database.deleteObjectStore(EARLIER);
  };
}

/**
 * @param {IDBObjectStore} store
 * @param {EventTarget | null} target a request that has been answered
 */
function keepIfThere(store, target) {
  const kept = /** @type {IDBRequest} */ (target).result;
  if (kept) store.put({ ...kept, at: 0 }, "earlier");
}

/**
 * @template T
 * @param {IDBRequest<T>} request
 * @returns {Promise<T>}
 */
function result(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
    if (request instanceof IDBOpenDBRequest) request.onblocked = () => reject(new Error("another tab holds the database"));
  });
}
