import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { alike, journey } from "./journey.mjs";
import { keptWorks } from "./kept.mjs";
import { asJpeg } from "./pictures.mjs";
import { anotherTab, continueIn, standing, untilKept } from "./tabs.mjs";
import { SAMPLE } from "./visitor.mjs";

journey("where the space runs out as the work is committed, the page says once that it is not kept, and goes on", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  const browser = await page.context().newCDPSession(page);
  const { origin } = new URL(page.url());
  await browser.send("Storage.overrideQuotaForOrigin", { origin, quotaSize: 20_000 });
  await visitor.dropSample();
  await expectNotKept(visitor);
  assert.deepEqual(await keptWorks(page), []);
  await edit(visitor, 9);
  const work = await standing(visitor);
  await page.waitForTimeout(1000);
  assert.ok(await page.isHidden("#notice"), "it is said again");

  // Once there is space, the next change brings everything to the database.
  await browser.send("Storage.overrideQuotaForOrigin", { origin });
  await visitor.offset("y", 4);
  const next = await standing(visitor);
  assert.notDeepEqual(next, work);
  await untilKept(visitor, 1);
  await page.reload();
  await continueIn(visitor);
  assert.deepEqual(await standing(visitor), next);
});

for (const [what, remove] of alike(/** @type {const} */ ([
  ["is deleted", deleteDatabase],
  ["loses the face", (page) => clearStore(page, "faces")],
  ["loses what was done", (page) => clearStore(page, "done")],
]))) {
  journey(`the next change brings back everything to a database that ${what} while the page is open`, async (open) => {
    const visitor = await open();
    const { page } = visitor;
    await visitor.dropSample();
    await edit(visitor, 9);
    await untilKept(visitor, 1);
    const other = await anotherTab(visitor, page.url());
    await remove(other.page);
    await page.bringToFront();
    await visitor.offset("y", 4);
    const work = await standing(visitor);
    await untilKept(visitor, 1);
    assert.ok(await page.isHidden("#notice"));
    await page.reload();
    await continueIn(visitor);
    assert.deepEqual(await standing(visitor), work);
    other.checkNothingBroke();
  });
}

journey("where the database is of another version, the page says that nothing is kept, and goes on", async (open) => {
  const visitor = await open();
  await visitor.page.evaluate(() => new Promise((resolve) => (indexedDB.open("rosto", 2).onsuccess = ({ target }) => resolve(target.result.close()))));
  await visitor.dropSample();
  await expectNotKept(visitor);
  await edit(visitor, 9);
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

journey("works that are damaged in whatever way hide no older one", async (open) => {
  const visitor = await open();
  await visitor.dropSample();
  await edit(visitor, 9);
  const work = await standing(visitor);
  await untilKept(visitor, 1);
  const next = await anotherTab(visitor, visitor.page.url());
  await next.page.evaluate(`(${addDamaged})([${DAMAGES}])`);
  await visitor.page.goto("about:blank");
  await next.page.reload();
  await continueIn(next);
  assert.deepEqual(await standing(next), work);
  assert.equal((await next.notice()).code, "earlier-work");
  next.checkNothingBroke();
});

for (const [what, isLost, found] of /** @type {const} */ ([
  ["picture", "(size) => size > 1e6", "older"],
  ["photo's own file", "(size) => size === 1", "latest"],
])) {
  journey(`where the ${what} of the latest work cannot be read, the ${found} work is opened`, async (open) => {
    const { visitor, ...works } = await twoWorks(open);
    await visitor.page.evaluate(`(${loseBlob})(${isLost})`);
    await continueIn(visitor);
    assert.deepEqual(await standing(visitor), works[found]);
  });
}

for (const [what, seize] of alike(/** @type {const} */ ([
  ["keeps the database from opening", seizeDatabase],
  ["has a transaction that does not end", seizeStores],
]))) {
  journey(`while another tab ${what}, the page says once that nothing is kept, and later keeps all of it`, async (open) => {
    const visitor = await open();
    const { page } = visitor;
    await visitor.dropSample();
    await edit(visitor, 9);
    await untilKept(visitor, 1);
    const other = await anotherTab(visitor, page.url());
    await other.page.evaluate(seize);

    await page.bringToFront();
    await visitor.offset("y", 4);
    await expectNotKept(visitor);
    await visitor.offset("y", 6);
    const work = await standing(visitor);
    await page.waitForTimeout(8000);
    assert.ok(await page.isHidden("#notice"), "it is said again");

    await other.page.evaluate(() => globalThis.release());
    await visitor.offset("x", 2);
    const next = await standing(visitor);
    assert.notDeepEqual(next, work);
    await untilKept(visitor, 1);
    await page.waitForTimeout(1000);
    assert.equal((await keptWorks(page)).length, 1);
    await page.reload();
    await continueIn(visitor);
    assert.deepEqual(await standing(visitor), next);
    other.checkNothingBroke();
  });
}

journey("work that cannot be read for another tab's sake is not said to be damaged", async (open) => {
  const { visitor, latest } = await twoWorks(open);
  const { page } = visitor;
  const other = await anotherTab(visitor, page.url());
  await other.page.evaluate(seizeStores);
  await page.bringToFront();
  await page.click("#continue");
  assert.equal((await visitor.notice()).code, "kept-work-busy");
  await other.page.evaluate(() => globalThis.release());
  await continueIn(visitor);
  assert.deepEqual(await standing(visitor), latest);
});

journey("locks that are not answered keep no work from being kept and opened again", async (open) => {
  const visitor = await open({ before: (context) => context.addInitScript(muteLocks) });
  const { page } = visitor;
  await visitor.dropSample();
  await edit(visitor, 9);
  const work = await standing(visitor);
  await page.waitForTimeout(6000);
  assert.ok(await page.isHidden("#notice"));
  await page.reload();
  await continueIn(visitor);
  assert.deepEqual(await standing(visitor), work);
});

journey("the latest work is the one that was kept last, however the clock was set in between", async (open) => {
  const first = await open();
  const address = first.page.url();
  await first.dropSample();
  await edit(first, 9);
  await untilKept(first, 1);

  const second = await anotherTab(first, address, setClockBack);
  await second.drop(await asJpeg(second.page, await readFile(SAMPLE), { width: 640, height: 480 }), "other.jpg");
  await second.untilFace();
  await edit(second, -6);
  const latest = await standing(second);
  await untilKept(second, 2);
  for (const { page } of [first, second]) await page.goto("about:blank");

  const third = await anotherTab(first, address);
  await continueIn(third);
  assert.deepEqual(await standing(third), latest);
  // So too with what only the last moment has said.
  await third.findLandmark("nose tip");
  await third.page.evaluate(setClockBack);
  await third.page.evaluate(() => {
    const field = document.querySelector("#landmark-sliders [data-axis='z'] input[type=number]");
    field.value = "3";
    field.dispatchEvent(new Event("input"));
    field.dispatchEvent(new Event("change"));
  });
  await third.page.goto("about:blank");
  const fourth = await anotherTab(first, address);
  await continueIn(fourth);
  await fourth.findLandmark("nose tip");
  assert.equal(Number(await fourth.page.inputValue("#landmark-sliders [data-axis='z'] input[type=number]")), 3);
  for (const visitor of [third, fourth]) visitor.checkNothingBroke();
}, { isRare: true });

/** Two works of one visitor, who is back on the page; the latest is the one of the sample itself. */
async function twoWorks(open) {
  const visitor = await open();
  const { page } = visitor;
  await visitor.drop(await asJpeg(page, await readFile(SAMPLE), { width: 640, height: 480 }), "older.jpg");
  await visitor.untilFace();
  await edit(visitor, -6);
  const older = await standing(visitor);
  await untilKept(visitor, 1);
  await visitor.dropSample();
  await page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
  await edit(visitor, 9);
  const latest = await standing(visitor);
  await untilKept(visitor, 2);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  return { visitor, older, latest };
}

async function edit(visitor, offset_mm) {
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", offset_mm);
}

async function expectNotKept(visitor) {
  await visitor.page.waitForSelector("#notice[data-code='not-kept']");
  await visitor.page.keyboard.press("Escape");
  await visitor.page.waitForSelector("#notice", { state: "hidden" });
}

/** Runs in the page: adds a later work for each kind of damage, made of the one that is kept. */
async function addDamaged(damages) {
  const answer = (request) => new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
  const database = await answer(indexedDB.open("rosto"));
  const transaction = database.transaction(["faces", "done"], "readwrite");
  const stores = ["faces", "done"].map((name) => transaction.objectStore(name));
  const [[face], [done]] = await Promise.all(stores.map((store) => answer(store.getAll())));
  for (const [place, damage] of damages.entries()) {
    const rows = damage(face, { ...done, order: done.order + 1 + place });
    for (const [index, store] of stores.entries()) if (rows[index] !== undefined) store.put(rows[index], `damaged-${place}`);
  }
  await new Promise((resolve) => (transaction.oncomplete = resolve));
  database.close();
}

/** @param {import("playwright-core").Page} page */
function deleteDatabase(page) {
  return page.evaluate(() => new Promise((resolve) => (indexedDB.deleteDatabase("rosto").onsuccess = () => resolve())));
}

/** @param {import("playwright-core").Page} page @param {string} name */
function clearStore(page, name) {
  return page.evaluate(async (name) => {
    const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
    const transaction = database.transaction(name, "readwrite");
    transaction.objectStore(name).clear();
    await new Promise((resolve) => (transaction.oncomplete = resolve));
    database.close();
  }, name);
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

/** Refuses the first of the blobs that are so large. */
function loseBlob(isLost) {
  const { arrayBuffer } = Blob.prototype;
  let isDone = false;
  Blob.prototype.arrayBuffer = function () {
    if (isDone || !isLost(this.size)) return arrayBuffer.call(this);
    isDone = true;
    return Promise.reject(new DOMException("The file could not be read.", "NotReadableError"));
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
