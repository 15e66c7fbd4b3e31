import { withTimeout } from "./timeout.ts";

/**
 * The IndexedDB database. A slot has one row in each store: `faces` holds the face with its photos, `done` its edits,
 * which change often. Another tab can block opening or a transaction indefinitely, so each step has a timeout.
 */
type Stores = { faces: IDBObjectStore; done: IDBObjectStore; };

const DATABASE = "rosto";
const VERSION = 1;
const STORES = ["faces", "done"];

const OPEN_MS = 5000;
const BEGIN_MS = 5000;
/** Full-size photos can amount to hundreds of megabytes. */
const COMMIT_MS = 20_000;

/** Index of the `done` store by save order. */
export const ORDER = "order";

/**
 * Runs `act` in one transaction over both stores. Resolves after the commit: a request that succeeded can still be
 * rolled back, for example on a full disk.
 *
 * @param act may await requests to these stores only
 */
export async function transact<T>(mode: IDBTransactionMode, act: (stores: Stores) => Promise<T>): Promise<T> {
  const database = await open();
  try {
    return await committed(database.transaction(STORES, mode), act);
  } finally {
    database.close();
  }
}

/** The result of a request as a promise. */
export function resultOf<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

async function committed<T>(transaction: IDBTransaction, act: (stores: Stores) => Promise<T>) {
  const completed = new Promise((resolve, reject) => {
    transaction.oncomplete = resolve;
    transaction.onabort = () => reject(transaction.error ?? new Error("the transaction was aborted"));
  });
  // Awaited below; this avoids an unhandled rejection until then.
  completed.catch(() => {});
  const stores = { faces: transaction.objectStore("faces"), done: transaction.objectStore("done") };
  try {
    // A transaction starts after earlier ones, including those of other tabs.
    await withTimeout(BEGIN_MS, resultOf(stores.done.count()), "beginning a transaction");
    const [value] = await withTimeout(COMMIT_MS, Promise.all([act(stores), completed]), "committing a transaction");
    return value;
  } catch (error) {
    abort(transaction);
    throw error;
  }
}

function abort(transaction: IDBTransaction) {
  try {
    transaction.abort();
  } catch {
    // Already committed or aborted.
  }
}

async function open() {
  const request = indexedDB.open(DATABASE, VERSION);
  request.onupgradeneeded = () => create(request.result);
  const opening = resultOf(request);
  try {
    const database = await withTimeout(OPEN_MS, opening, "opening the database");
    // Do not block an upgrade by a newer version of the page.
    database.onversionchange = () => database.close();
    return database;
  } catch (error) {
    opening.then((database) => database.close(), () => {});
    throw error;
  }
}

function create(database: IDBDatabase) {
  const [, done] = STORES.map((name) => database.createObjectStore(name));
  done?.createIndex(ORDER, ORDER);
}
