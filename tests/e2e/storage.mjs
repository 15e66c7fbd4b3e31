import { expect } from "@playwright/test";

/** @typedef {{ slot: string, name: string | undefined, isLocked: boolean, edits: string, order: number }} StoredWork */

/**
 * Saved works in the browser's database that have a face, and whether a tab holds the lock of each.
 *
 * @returns {Promise<StoredWork[]>}
 */
export function storedWorks(page) {
  return page.evaluate(async () => {
    const answer = (request) => new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    const database = await answer(indexedDB.open("rosto"));
    const transaction = database.transaction(["faces", "done"]);
    const [doneTo, faces] = ["done", "faces"].map((name) => transaction.objectStore(name));
    const [slots, done, keys, all] = await Promise.all([doneTo.getAllKeys(), doneTo.getAll(), faces.getAllKeys(), faces.getAll()].map(answer));
    database.close();
    const { held } = await navigator.locks.query();
    const isLocked = (slot) => held.some(({ name }) => name === `rosto-slot-${slot}`);
    const face = (slot) => all[keys.indexOf(slot)];
    const works = slots.map((slot, place) => ({ slot, ...done[place], name: face(slot)?.name, isLocked: isLocked(slot) }));
    return works.filter(({ slot }) => keys.includes(slot));
  });
}

/**
 * Changes the browser's database.
 *
 * @param {import("@playwright/test").Page} page
 * @param {((stores: Record<"faces" | "done", IDBObjectStore>) => unknown) | string} change function or its source, runs in the page
 */
export function changeStorage(page, change) {
  return page.evaluate(`(${inDatabase})(${change})`);
}

/** Runs in the page. */
async function inDatabase(change) {
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  const transaction = database.transaction(["faces", "done"], "readwrite");
  const completed = new Promise((resolve) => (transaction.oncomplete = resolve));
  change({ faces: transaction.objectStore("faces"), done: transaction.objectStore("done") });
  await completed;
  database.close();
}

/**
 * Waits until the database contains the page's current work, and at least `count` works. The page saves when it is
 * hidden.
 */
export async function untilSaved(page, count = 1) {
  const unsaved = await page.evaluate(hide);
  await expect(async () => {
    const works = await storedWorks(page);
    expect(works.length).toBeGreaterThanOrEqual(count);
    if (unsaved) expect(works).toContainEqual(expect.objectContaining(unsaved));
  }).toPass({ timeout: 20_000 });
}

/** Runs in the page. @returns the work to be saved; undefined if it is saved already */
function hide() {
  const before = { ...localStorage };
  Object.defineProperty(document, "visibilityState", { configurable: true, get: () => "hidden" });
  document.dispatchEvent(new Event("visibilitychange"));
  Reflect.deleteProperty(document, "visibilityState");
  const draftKey = Object.keys(localStorage).find((key) => key.startsWith("rosto-drafts-") && localStorage[key] !== before[key]);
  if (!draftKey) return undefined;
  const { order: _, ...unsaved } = JSON.parse(localStorage[draftKey]);
  return unsaved;
}
