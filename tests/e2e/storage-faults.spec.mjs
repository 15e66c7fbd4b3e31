import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { PREVIOUS_FACE, openOther } from "./groups.mjs";
import { changeStorage, storedWorks, untilSaved } from "./storage.mjs";

/** Longer than the page's timeouts for database and locks. */
const TIMEOUT_S = 8;

test("if the quota is exceeded on commit, a notice says once that work is not saved, and editing continues", async ({ open }) => {
  const visitor = await open({ scripts: [countAborts] });
  const { page } = visitor;
  const browser = await page.context().newCDPSession(page);
  const { origin } = new URL(page.url());
  await browser.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: 20_000 });
  await visitor.openFace();
  await expectNotSaved(visitor);
  assert.deepEqual(await storedWorks(page), []);
  const aborts = await page.evaluate("aborts");
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.work();
  await page.waitForFunction((before) => globalThis.aborts > before, aborts);
  await visitor.frames(2);
  assert.ok(await page.isHidden("#notice"), "the notice is repeated");

  // With space available, the next change saves everything.
  await browser.send("Storage.overrideQuotaForOrigin", { origin });
  await visitor.setOffset("y", 4);
  const next = await visitor.work();
  assert.notDeepEqual(next, work);
  await visitor.reloadAndResume();
  assert.deepEqual(await visitor.work(), next);
});

for (const [what, remove] of /** @type {const} */ ([
  ["is deleted", (page) => page.evaluate(() => new Promise((resolve) => (indexedDB.deleteDatabase("rosto").onsuccess = () => resolve())))],
  ["loses the face", (page) => changeStorage(page, ({ faces }) => faces.clear())],
  ["loses the edits", (page) => changeStorage(page, ({ done }) => done.clear())],
])) {
  test(`the next change saves everything again if the database ${what} while the page is open`, async ({ editor, page }) => {
    await editor.move("nose tip", "z", 9);
    await untilSaved(editor.page);
    const other = await editor.openTab();
    await remove(other.page);
    await page.bringToFront();
    await editor.setOffset("y", 4);
    const work = await editor.work();
    await untilSaved(editor.page);
    assert.ok(await page.isHidden("#notice"));
    await editor.reloadAndResume();
    assert.deepEqual(await editor.work(), work);
  });
}

test("with a database of another version, a notice says that work is not saved, and editing continues", async ({ visitor, page }) => {
  await page.evaluate(() => new Promise((resolve) => (indexedDB.open("rosto", 2).onsuccess = ({ target }) => resolve(target.result.close()))));
  await visitor.dropSample();
  await expectNotSaved(visitor);
  await visitor.move("nose tip", "z", 9);
});

/** Kinds of damage to saved work. */
const DAMAGES = [
  (face, done) => [{ ...face, files: face.files.map(({ file: _, ...source }) => source) }, done],
  (face, done) => [{ ...face, files: "files" }, done],
  ({ name: _, ...face }, done) => [face, done],
  (face, done) => [face, { ...done, photos: done.photos.slice(0, 20) }],
  (face, done) => [face, { ...done, photos: "[]" }],
  (face, done) => [face, { ...done, pictures: done.pictures[0] }],
  (_, done) => ["a face", done],
  (_, done) => [undefined, done],
  (face) => [face, undefined],
  (face, done) => [face, { ...done, edits: done.edits.slice(0, 20) }],
  (face, { order: _, ...done }) => [face, { ...done, edits: 7 }],
];

test("damaged works do not hide an older one", async ({ editor }) => {
  await editor.move("nose tip", "z", 9);
  const work = await editor.work();
  await untilSaved(editor.page);
  const next = await editor.openTab();
  await changeStorage(next.page, `(stores) => (${addDamaged})(stores, [${DAMAGES}])`);
  await editor.page.goto("about:blank");
  await next.reloadAndResume();
  assert.deepEqual(await next.work(), work);
  assert.equal((await next.notice()).code, "earlier-work");
});

test("if a file of the latest work cannot be read, the older work opens", async ({ open }) => {
  const { visitor, older } = await twoWorks(open);
  await visitor.page.evaluate(failRead);
  await visitor.resume();
  assert.deepEqual(await visitor.work(), older);
});

for (const [what, block] of /** @type {const} */ ([
  ["blocks the database", blockDatabase],
  ["has an endless transaction", blockStores],
])) {
  test(`while another tab ${what}, a notice says once that work is not saved, and later all of it is`, async ({ open }) => {
    const visitor = await open({ hasClock: true });
    const { page } = visitor;
    await visitor.openFace();
    await visitor.move("nose tip", "z", 9);
    await untilSaved(visitor.page);
    const other = await visitor.openTab();
    await other.page.evaluate(block);

    await page.bringToFront();
    await visitor.setOffset("y", 4);
    await advance(visitor, TIMEOUT_S);
    await expectNotSaved(visitor);
    await visitor.setOffset("y", 6);
    const work = await visitor.work();
    await advance(visitor, TIMEOUT_S);
    assert.ok(await page.isHidden("#notice"), "the notice is repeated");

    await other.page.evaluate(() => globalThis.release());
    await visitor.setOffset("x", 2);
    const next = await visitor.work();
    assert.notDeepEqual(next, work);
    await untilSaved(visitor.page);
    assert.equal((await storedWorks(page)).length, 1);
    await visitor.reloadAndResume();
    assert.deepEqual(await visitor.work(), next);
  });
}

test("work blocked by another tab is not reported as damaged", async ({ open }) => {
  const { visitor, latest } = await twoWorks(open);
  const { page } = visitor;
  const other = await visitor.openTab();
  await other.page.evaluate(blockStores);
  await page.bringToFront();
  await page.click("#continue");
  await advance(visitor, TIMEOUT_S);
  assert.equal((await visitor.notice()).code, "kept-work-busy");
  await other.page.evaluate(() => globalThis.release());
  await visitor.resume();
  assert.deepEqual(await visitor.work(), latest);
});

test("work is saved and reopened even if locks do not respond", async ({ open }) => {
  const visitor = await open({ hasClock: true, scripts: [muteLocks] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.work();
  await advance(visitor, TIMEOUT_S);
  assert.ok(await page.isHidden("#notice"));
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.work(), work);
});

test("a lock that a busy browser grants late is used", async ({ open }) => {
  const visitor = await open({ scripts: [delayLocks] });
  await visitor.openFace();
  await visitor.move("nose tip", "z", 9);
  await untilSaved(visitor.page);
  // A later save waits for the lock.
  await visitor.move("bottom of the chin", "y", -4);
  await untilSaved(visitor.page);
  assert.deepEqual((await storedWorks(visitor.page)).map(({ isLocked }) => isLocked), [true]);
});

test("a lock that a busy browser ends late is not another tab's", async ({ open }) => {
  const visitor = await open({ scripts: [endLocksLate] });
  await visitor.openFace();
  await openOther(visitor);
  await visitor.page.click(PREVIOUS_FACE);
  await visitor.untilFace();
  await visitor.move("nose tip", "z", 9);
  await untilSaved(visitor.page, 2);
  const areLocked = async () => (await storedWorks(visitor.page)).map(({ isLocked }) => isLocked);
  // Once the ends of the earlier locks have arrived.
  await expect.poll(async () => (await areLocked()).toSorted(), { timeout: 30_000 }).toEqual([false, true]);
});

test("after a reload, this tab's work is offered although a busy browser still holds its lock", async ({ open }) => {
  const visitor = await open({ scripts: [holdSlotUntilSeen] });
  await openOther(visitor, "older.jpg");
  await untilSaved(visitor.page);
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 9);
  const latest = await visitor.work();
  await untilSaved(visitor.page, 2);
  await visitor.page.reload();
  await visitor.page.waitForSelector("#continue:not([hidden])");
  await visitor.resume();
  assert.deepEqual(await visitor.work(), latest);
});

test("the last saved work counts as the latest, regardless of clock changes", async ({ open }) => {
  const first = await open();
  await first.openFace();
  await first.move("nose tip", "z", 9);
  await untilSaved(first.page);

  const second = await first.openTab(setClockBack);
  await openOther(second);
  await second.move("nose tip", "z", -6);
  const latest = await second.work();
  await untilSaved(second.page, 2);
  for (const { page } of [first, second]) await page.goto("about:blank");

  const third = await first.openTab();
  await third.resume();
  assert.deepEqual(await third.work(), latest);
  // The same for drafts, which are saved when the page is hidden.
  const offset_mm = ({ page }) => page.locator("#landmark-offset [data-axis='z'] .number-field");
  await third.findLandmark("nose tip");
  await third.page.evaluate(setClockBack);
  await offset_mm(third).evaluate((field) => {
    field.value = "3";
    field.dispatchEvent(new Event("input"));
    field.dispatchEvent(new Event("change"));
  });
  await third.page.goto("about:blank");
  const fourth = await first.openTab();
  await fourth.resume();
  await fourth.findLandmark("nose tip");
  assert.equal(Number(await offset_mm(fourth).inputValue()), 3);
});

/** Saves two works and returns to the empty page; the latest is the sample. */
async function twoWorks(open) {
  const visitor = await open({ hasClock: true });
  const { page } = visitor;
  await openOther(visitor, "older.jpg");
  await visitor.move("nose tip", "z", -6);
  const older = await visitor.work();
  await untilSaved(visitor.page);
  await visitor.dropSample();
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 0);
  await visitor.move("nose tip", "z", 9);
  const latest = await visitor.work();
  await untilSaved(visitor.page, 2);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  return { visitor, older, latest };
}

/** Advances the page's clock, with time for the database after each second. */
async function advance(visitor, seconds) {
  for (let second = 0; second < seconds; second++) {
    await visitor.page.clock.runFor(1000);
    await visitor.frames(3);
  }
}

async function expectNotSaved(visitor) {
  await visitor.page.waitForSelector("#notice[data-code='not-kept']");
  await visitor.page.keyboard.press("Escape");
  await visitor.page.waitForSelector("#notice", { state: "hidden" });
}

/** Runs in the page: adds a newer work with each kind of damage, derived from the saved one. */
async function addDamaged({ faces, done }, damages) {
  const first = (store) => new Promise((resolve) => (store.getAll().onsuccess = ({ target }) => resolve(target.result[0])));
  const [face, work] = await Promise.all([first(faces), first(done)]);
  for (const [place, damage] of damages.entries()) {
    const rows = damage(face, { ...work, order: work.order + 1 + place });
    for (const [index, store] of [faces, done].entries()) if (rows[index] !== undefined) store.put(rows[index], `damaged-${place}`);
  }
}

/**
 * Runs in the page, as does the next function: blocks the database by a connection that stays open during an upgrade.
 */
async function blockDatabase() {
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  const request = indexedDB.open("rosto", database.version + 1);
  request.onupgradeneeded = () => request.transaction.abort();
  request.onerror = (event) => event.preventDefault();
  globalThis.release = () => database.close();
}

async function blockStores() {
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  let isReleased = false;
  const store = database.transaction(["faces", "done"], "readwrite").objectStore("faces");
  const goOn = () => {
    if (isReleased) database.close();
    else store.count().onsuccess = goOn;
  };
  goOn();
  globalThis.release = () => (isReleased = true);
}

/** Runs in the page, as do the next functions: the first file cannot be read. */
function failRead() {
  const { arrayBuffer } = Blob.prototype;
  Blob.prototype.arrayBuffer = () => {
    Blob.prototype.arrayBuffer = arrayBuffer;
    return Promise.reject(new DOMException("The file could not be read.", "NotReadableError"));
  };
}

function countAborts() {
  globalThis.aborts = 0;
  const { abort } = IDBTransaction.prototype;
  IDBTransaction.prototype.abort = function () {
    globalThis.aborts += 1;
    abort.call(this);
  };
}

/** Runs in the page: after a reload, the tab's slot is held until the page has seen that. */
function holdSlotUntilSeen() {
  const slot = sessionStorage.getItem("rosto.slot");
  if (!slot) return;
  const { locks } = navigator;
  const query = locks.query.bind(locks);
  const name = `rosto-slot-${slot}`;
  const seen = new Promise((resolve) => {
    locks.query = async () => {
      const answer = await query();
      if (answer.held?.some((lock) => lock.name === name)) resolve(undefined);
      return answer;
    };
  });
  locks.request(name, () => seen);
}

/** Runs in the page: locks are held at once, but the page learns of it after its limit of a second. */
function delayLocks() {
  const { locks } = navigator;
  const [request, query] = [locks.request.bind(locks), locks.query.bind(locks)];
  const after = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
  locks.request = (name, ...rest) => {
    const [hold] = rest.slice(-1);
    if (!name.startsWith("rosto-slot-")) return request(name, ...rest);
    return request(name, ...rest.slice(0, -1), async (lock) => {
      await after(1100);
      return hold(lock);
    });
  };
  locks.query = async () => {
    await after(1500);
    return query();
  };
}

/** Runs in the page: a released lock stays held for some seconds. */
function endLocksLate() {
  const { locks } = navigator;
  const request = locks.request.bind(locks);
  locks.request = (name, ...rest) => {
    const [hold] = rest.slice(-1);
    if (!name.startsWith("rosto-slot-")) return request(name, ...rest);
    return request(name, ...rest.slice(0, -1), async (lock) => {
      await hold(lock);
      await new Promise((resolve) => setTimeout(resolve, 8000));
    });
  };
}

function muteLocks() {
  LockManager.prototype.request = () => new Promise(() => {});
  LockManager.prototype.query = () => new Promise(() => {});
}

function setClockBack() {
  const { now } = Date;
  Date.now = () => now() - 400 * 24 * 3600 * 1000;
}
