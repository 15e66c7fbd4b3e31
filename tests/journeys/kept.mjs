import { expect } from "@playwright/test";

/** @typedef {{ slot: string, name: string | undefined, isHeld: boolean, edits: string, order: number }} Kept */

/**
 * Works in the browser's database that have a face, what was done to it, and whether a tab has it open.
 *
 * @param {import("@playwright/test").Page} page
 * @returns {Promise<Kept[]>}
 */
export function keptWorks(page) {
  return page.evaluate(async () => {
    const answer = (request) => new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    const database = await answer(indexedDB.open("rosto"));
    const transaction = database.transaction(["faces", "done"]);
    const [doneTo, faces] = ["done", "faces"].map((name) => transaction.objectStore(name));
    const [slots, done, keys, all] = await Promise.all([doneTo.getAllKeys(), doneTo.getAll(), faces.getAllKeys(), faces.getAll()].map(answer));
    database.close();
    const { held } = await navigator.locks.query();
    const isHeld = (slot) => held.some(({ name }) => name === `rosto-slot-${slot}`);
    const face = (slot) => all[keys.indexOf(slot)];
    const works = slots.map((slot, place) => ({ slot, ...done[place], name: face(slot)?.name, isHeld: isHeld(slot) }));
    return works.filter(({ slot }) => keys.includes(slot));
  });
}

/**
 * Waits until the database has all that was done on a page, which writes it at once when it goes out of sight.
 *
 * @param {import("@playwright/test").Page} page
 * @param {number} [count] of the works that have to be there at least
 */
export async function untilKept(page, count = 1) {
  const unkept = await page.evaluate(goOutOfSight);
  await expect(async () => {
    const works = await keptWorks(page);
    expect(works.length).toBeGreaterThanOrEqual(count);
    if (unkept) expect(works).toContainEqual(expect.objectContaining(unkept));
  }).toPass({ timeout: 20_000 });
}

/** Runs in the page. @returns what the database does not have yet of its work; nothing if it has everything */
function goOutOfSight() {
  Object.defineProperty(document, "visibilityState", { configurable: true, get: () => "hidden" });
  document.dispatchEvent(new Event("visibilitychange"));
  Reflect.deleteProperty(document, "visibilityState");
  const spoken = Object.keys(localStorage).filter((key) => key.startsWith("rosto-last-words-"));
  const [latest] = spoken.map((key) => JSON.parse(localStorage[key])).sort((one, other) => other.order - one.order);
  if (!latest) return undefined;
  const { order: _, ...unkept } = latest;
  return unkept;
}
