/** @typedef {import("./work.js").Work} Work */
/** @typedef {import("./work.js").OpenedFace} OpenedFace */
/** @typedef {Omit<Work, "face">} Edits */

const DATABASE = "rosto";
const STORE = "work";

/**
 * The work kept in this browser from the last visit, if there is any.
 *
 * @returns {Promise<Work | undefined>}
 */
export async function keptWork() {
  const store = await open("readonly");
  const [face, edits] = await Promise.all([result(store.get("face")), result(store.get("edits"))]);
  if (!face || !edits) return undefined;
  const picture = new Uint8Array(await face.picture.arrayBuffer());
  return { face: { ...face, picture }, ...edits };
}

/**
 * Keeps a newly opened face; its edits come later, one by one.
 *
 * @param {OpenedFace} face
 * @param {Edits} edits
 */
export async function keepFace(face, edits) {
  const store = await open("readwrite");
  // As a blob the pixels are handed to the database outside the page's own thread.
  const stored = { ...face, picture: new Blob([/** @type {BlobPart} */ (face.picture)]) };
  await Promise.all([result(store.put(stored, "face")), result(store.put(edits, "edits"))]);
}

/** @param {Edits} edits */
export async function keepEdits(edits) {
  const store = await open("readwrite");
  await result(store.put(edits, "edits"));
}

/** @param {IDBTransactionMode} mode */
async function open(mode) {
  const request = indexedDB.open(DATABASE, 1);
  request.onupgradeneeded = () => request.result.createObjectStore(STORE);
  const database = await result(request);
  const transaction = database.transaction(STORE, mode);
  const close = () => database.close();
  transaction.oncomplete = close;
  transaction.onabort = close;
  return transaction.objectStore(STORE);
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
  });
}
