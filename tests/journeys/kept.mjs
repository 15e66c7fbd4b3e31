/** @typedef {{ slot: string, name: string | undefined, isHeld: boolean, edits: string, order: number }} Kept */

/**
 * The works in the browser's database that have a face, what was done to it, and whether a tab has it open.
 *
 * @param {import("playwright-core").Page} page
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
