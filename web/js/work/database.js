/**
 * The browser's database. A slot has a row in both of its stores: a face with its photos, and what was done to it, which
 * changes often. Another tab can keep a database from opening, or a transaction from beginning, for as long as it likes:
 * each wait has a limit.
 *
 * @typedef {{ faces: IDBObjectStore, done: IDBObjectStore }} Stores
 */
import { within } from "./within.js";

const DATABASE = "rosto";
const VERSION = 1;
const STORES = ["faces", "done"];

const OPENING_MS = 5000;
const STARTING_MS = 5000;
/** Several photos of full size are hundreds of megabytes. */
const FINISHING_MS = 20_000;

/** The index of {@link Stores} `done` by the order in which works were kept. */
export const ORDER = "order";

/**
 * Reads or writes both stores in one transaction, and resolves once it is committed: what a request has stored may still be
 * undone, for want of space for example.
 *
 * @template T
 * @param {IDBTransactionMode} mode
 * @param {(stores: Stores) => Promise<T>} act may wait for requests to these stores alone
 * @returns {Promise<T>}
 */
export async function transact(mode, act) {
  const database = await open();
  try {
    return await committed(database.transaction(STORES, mode), act);
  } finally {
    database.close();
  }
}

/**
 * @template T
 * @param {IDBRequest<T>} request
 * @returns {Promise<T>}
 */
export function answer(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}

/**
 * @template T
 * @param {IDBTransaction} transaction
 * @param {(stores: Stores) => Promise<T>} act
 */
async function committed(transaction, act) {
  const ended = new Promise((resolve, reject) => {
    transaction.oncomplete = resolve;
    transaction.onabort = () => reject(transaction.error ?? new Error("the transaction was aborted"));
  });
  // Whoever waits for it hears of it below.
  ended.catch(() => {});
  const stores = { faces: transaction.objectStore("faces"), done: transaction.objectStore("done") };
  try {
    // A transaction waits for those before it, other tabs' among them.
    await within(STARTING_MS, answer(stores.done.count()), "beginning a transaction");
    const [value] = await within(FINISHING_MS, Promise.all([act(stores), ended]), "ending a transaction");
    return value;
  } catch (error) {
    abort(transaction);
    throw error;
  }
}

/** @param {IDBTransaction} transaction */
function abort(transaction) {
  try {
    transaction.abort();
  } catch {
    // It has come to an end by itself.
  }
}

async function open() {
  const request = indexedDB.open(DATABASE, VERSION);
  request.onupgradeneeded = () => create(request.result);
  const opening = answer(request);
  try {
    const database = await within(OPENING_MS, opening, "opening the database");
    // A page of another version may want the database for itself.
    database.onversionchange = () => database.close();
    return database;
  } catch (error) {
    opening.then((database) => database.close(), () => {});
    throw error;
  }
}

/** @param {IDBDatabase} database that is new */
function create(database) {
  const [, done] = STORES.map((name) => database.createObjectStore(name));
  done?.createIndex(ORDER, ORDER);
}
