import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { openOther } from "./groups.mjs";
import { changeKept, keptWorks, untilKept } from "./kept.mjs";

/** Longer than the page waits for a database or a lock. */
const PATIENCE_S = 8;

test("where the space runs out as the work is committed, the page says once that it is not kept, and goes on", async ({ open }) => {
  const visitor = await open({ scripts: [countAborts] });
  const { page } = visitor;
  const browser = await page.context().newCDPSession(page);
  const { origin } = new URL(page.url());
  await browser.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: 20_000 });
  await visitor.openFace();
  await expectNotKept(visitor);
  assert.deepEqual(await keptWorks(page), []);
  const aborts = await page.evaluate("aborts");
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.work();
  await page.waitForFunction((before) => globalThis.aborts > before, aborts);
  await visitor.frames(2);
  assert.ok(await page.isHidden("#notice"), "it is said again");

  // Once there is space, the next change brings everything to the database.
  await browser.send("Storage.overrideQuotaForOrigin", { origin });
  await visitor.offset("y", 4);
  const next = await visitor.work();
  assert.notDeepEqual(next, work);
  await visitor.comeBack();
  assert.deepEqual(await visitor.work(), next);
});

for (const [[what, remove], tag] of alike(/** @type {const} */ ([
  ["is deleted", (page) => page.evaluate(() => new Promise((resolve) => (indexedDB.deleteDatabase("rosto").onsuccess = () => resolve())))],
  ["loses the face", (page) => changeKept(page, ({ faces }) => faces.clear())],
  ["loses what was done", (page) => changeKept(page, ({ done }) => done.clear())],
]))) {
  test(`the next change brings back everything to a database that ${what} while the page is open`, { tag }, async ({ editor, page }) => {
    await editor.move("nose tip", "z", 9);
    await untilKept(editor.page);
    const other = await editor.anotherTab();
    await remove(other.page);
    await page.bringToFront();
    await editor.offset("y", 4);
    const work = await editor.work();
    await untilKept(editor.page);
    assert.ok(await page.isHidden("#notice"));
    await editor.comeBack();
    assert.deepEqual(await editor.work(), work);
  });
}

test("where the database is of another version, the page says that nothing is kept, and goes on", async ({ visitor, page }) => {
  await page.evaluate(() => new Promise((resolve) => (indexedDB.open("rosto", 2).onsuccess = ({ target }) => resolve(target.result.close()))));
  await visitor.dropSample();
  await expectNotKept(visitor);
  await visitor.move("nose tip", "z", 9);
});

/** What may be left of a kept work. */
const DAMAGES = [
  (face, done) => [{ ...face, picture: new Blob([new Uint8Array(7)]) }, done],
  ({ landmarks: _, ...face }, done) => [face, done],
  ({ lens: _, ...face }, done) => [face, done],
  (face, done) => [{ ...face, landmarks: [...face.landmarks].map(String) }, done],
  (_, done) => ["a face", done],
  (_, done) => [undefined, done],
  (face) => [face, undefined],
  (face, done) => [face, { ...done, edits: done.edits.slice(0, 20) }],
  (face, { order: _, ...done }) => [face, { ...done, edits: 7 }],
];

test("works that are damaged in whatever way hide no older one", async ({ editor }) => {
  await editor.move("nose tip", "z", 9);
  const work = await editor.work();
  await untilKept(editor.page);
  const next = await editor.anotherTab();
  await changeKept(next.page, `(stores) => (${addDamaged})(stores, [${DAMAGES}])`);
  await editor.page.goto("about:blank");
  await next.comeBack();
  assert.deepEqual(await next.work(), work);
  assert.equal((await next.notice()).code, "earlier-work");
});

for (const [what, isLost, found] of /** @type {const} */ ([
  ["picture", "(size) => size > 1e6", "older"],
  ["photo's own file", "(size) => size === 1", "latest"],
])) {
  test(`where the ${what} of the latest work cannot be read, the ${found} work is opened`, async ({ open }) => {
    const { visitor, ...works } = await twoWorks(open);
    await visitor.page.evaluate(`(${loseBlob})(${isLost})`);
    await visitor.resume();
    assert.deepEqual(await visitor.work(), works[found]);
  });
}

for (const [[what, seize], tag] of alike(/** @type {const} */ ([
  ["keeps the database from opening", seizeDatabase],
  ["has a transaction that does not end", seizeStores],
]))) {
  test(`while another tab ${what}, the page says once that nothing is kept, and later keeps all of it`, { tag }, async ({ open }) => {
    const visitor = await open({ hasClock: true });
    const { page } = visitor;
    await visitor.openFace();
    await visitor.move("nose tip", "z", 9);
    await untilKept(visitor.page);
    const other = await visitor.anotherTab();
    await other.page.evaluate(seize);

    await page.bringToFront();
    await visitor.offset("y", 4);
    await pass(visitor, PATIENCE_S);
    await expectNotKept(visitor);
    await visitor.offset("y", 6);
    const work = await visitor.work();
    await pass(visitor, PATIENCE_S);
    assert.ok(await page.isHidden("#notice"), "it is said again");

    await other.page.evaluate(() => globalThis.release());
    await visitor.offset("x", 2);
    const next = await visitor.work();
    assert.notDeepEqual(next, work);
    await untilKept(visitor.page);
    assert.equal((await keptWorks(page)).length, 1);
    await visitor.comeBack();
    assert.deepEqual(await visitor.work(), next);
  });
}

test("work that cannot be read for another tab's sake is not said to be damaged", async ({ open }) => {
  const { visitor, latest } = await twoWorks(open);
  const { page } = visitor;
  const other = await visitor.anotherTab();
  await other.page.evaluate(seizeStores);
  await page.bringToFront();
  await page.click("#continue");
  await pass(visitor, PATIENCE_S);
  assert.equal((await visitor.notice()).code, "kept-work-busy");
  await other.page.evaluate(() => globalThis.release());
  await visitor.resume();
  assert.deepEqual(await visitor.work(), latest);
});

test("locks that are not answered keep no work from being kept and opened again", async ({ open }) => {
  const visitor = await open({ hasClock: true, scripts: [muteLocks] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.work();
  await pass(visitor, PATIENCE_S);
  assert.ok(await page.isHidden("#notice"));
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.work(), work);
});

test("the latest work is the one that was kept last, however the clock was set in between", { tag: "@rare" }, async ({ open }) => {
  const first = await open();
  await first.openFace();
  await first.move("nose tip", "z", 9);
  await untilKept(first.page);

  const second = await first.anotherTab(setClockBack);
  await openOther(second);
  await second.move("nose tip", "z", -6);
  const latest = await second.work();
  await untilKept(second.page, 2);
  for (const { page } of [first, second]) await page.goto("about:blank");

  const third = await first.anotherTab();
  await third.resume();
  assert.deepEqual(await third.work(), latest);
  // So too with what only the last moment has said.
  const offset_mm = ({ page }) => page.locator("#landmark-sliders [data-axis='z'] input[type=number]");
  await third.findLandmark("nose tip");
  await third.page.evaluate(setClockBack);
  await offset_mm(third).evaluate((field) => {
    field.value = "3";
    field.dispatchEvent(new Event("input"));
    field.dispatchEvent(new Event("change"));
  });
  await third.page.goto("about:blank");
  const fourth = await first.anotherTab();
  await fourth.resume();
  await fourth.findLandmark("nose tip");
  assert.equal(Number(await offset_mm(fourth).inputValue()), 3);
});

/** Two works of one visitor, who is back on the page; the latest is the one of the sample itself. */
async function twoWorks(open) {
  const visitor = await open({ hasClock: true });
  const { page } = visitor;
  await openOther(visitor, "older.jpg");
  await visitor.move("nose tip", "z", -6);
  const older = await visitor.work();
  await untilKept(visitor.page);
  await visitor.dropSample();
  await page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
  await visitor.move("nose tip", "z", 9);
  const latest = await visitor.work();
  await untilKept(visitor.page, 2);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  return { visitor, older, latest };
}

/** Moves the page's clock on by `seconds`, and lets the database answer after each. */
async function pass(visitor, seconds) {
  for (let second = 0; second < seconds; second++) {
    await visitor.page.clock.runFor(1000);
    await visitor.frames(3);
  }
}

async function expectNotKept(visitor) {
  await visitor.page.waitForSelector("#notice[data-code='not-kept']");
  await visitor.page.keyboard.press("Escape");
  await visitor.page.waitForSelector("#notice", { state: "hidden" });
}

/** Runs in the page: adds a later work for each kind of damage, made of the one that is kept. */
async function addDamaged({ faces, done }, damages) {
  const first = (store) => new Promise((resolve) => (store.getAll().onsuccess = ({ target }) => resolve(target.result[0])));
  const [face, work] = await Promise.all([first(faces), first(done)]);
  for (const [place, damage] of damages.entries()) {
    const rows = damage(face, { ...work, order: work.order + 1 + place });
    for (const [index, store] of [faces, done].entries()) if (rows[index] !== undefined) store.put(rows[index], `damaged-${place}`);
  }
}

/** Runs in the page, as the next: another connection that does not close, and whoever waits for it to. */
async function seizeDatabase() {
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  const request = indexedDB.open("rosto", database.version + 1);
  request.onupgradeneeded = () => request.transaction.abort();
  request.onerror = (event) => event.preventDefault();
  globalThis.release = () => database.close();
}

async function seizeStores() {
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

/** Runs in the page, as the next: refuses the first of the blobs that are so large. */
function loseBlob(isLost) {
  const { arrayBuffer } = Blob.prototype;
  let isDone = false;
  Blob.prototype.arrayBuffer = function () {
    if (isDone || !isLost(this.size)) return arrayBuffer.call(this);
    isDone = true;
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

function muteLocks() {
  LockManager.prototype.request = () => new Promise(() => {});
  LockManager.prototype.query = () => new Promise(() => {});
}

function setClockBack() {
  const { now } = Date;
  Date.now = () => now() - 400 * 24 * 3600 * 1000;
}
