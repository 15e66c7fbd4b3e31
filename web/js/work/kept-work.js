/** @typedef {import("./work.js").Work} Work */
/** @typedef {import("./work.js").OpenedFace} OpenedFace */

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
  return face && typeof edits === "string" ? { face, edits } : undefined;
}

/**
 * Keeps a newly opened face; its edits come later, one by one.
 *
 * @param {OpenedFace} face
 * @param {string} edits
 */
export async function keepFace(face, edits) {
  const store = await open("readwrite");
  await Promise.all([result(store.put(face, "face")), result(store.put(edits, "edits"))]);
}

/** @param {string} edits */
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
