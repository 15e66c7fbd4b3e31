import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { untilKept } from "./kept.mjs";
import { Visitor } from "./visitor.mjs";
import { refuseDatabase } from "./watches.mjs";

test("an edit a moment before a reload, or before the tab is closed, is kept", async ({ visitor, page }) => {
  const address = page.url();
  await visitor.openFace();
  await visitor.move("nose tip", "z", 3);
  await untilKept(page);

  await typeAndGo(page, 7, "reload");
  await page.waitForSelector("#continue:not([hidden])");
  await visitor.resume();
  assert.equal(await noseOut(visitor), 7);

  await untilKept(page);
  const other = await page.context().newPage();
  await typeAndGo(page, -5, "stay");
  await page.close({ runBeforeUnload: true });
  const next = new Visitor(other);
  await other.goto(address);
  await other.waitForSelector("#continue:not([hidden])");
  await other.click("#continue");
  await next.untilFace();
  assert.equal(await noseOut(next), -5);
  await other.click("#toolbar [data-action='undo']");
  assert.equal(await noseOut(next), 7);
  next.checkNothingBroke();
});

test("an edit is kept however long before the reload it was made", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  // Around the pause after which the database is told, it has been asked and has not answered.
  for (const [place, wait_ms] of [185, 200, 205, 210, 220, 240].entries()) {
    await editor.findLandmark("nose tip");
    await typeAndGo(page, place + 2, "reload", wait_ms);
    await editor.resume();
    assert.equal(await noseOut(editor), place + 2, `${wait_ms} ms`);
  }
});

for (const [[how, refuse], tag] of alike(/** @type {const} */ ([
  ["throws", refuseDatabase],
  ["answers with an error", refuseByError],
  ["is full", refuseByFullness],
]))) {
  test(`where the database ${how}, the page says once that nothing is kept, and the work goes on`, { tag }, async ({ open }) => {
    const visitor = await open({ scripts: [refuse] });
    const { page } = visitor;
    await visitor.openFace();
    await page.waitForSelector("#notice[data-code='not-kept']");
    assert.match((await visitor.notice()).text, /keeps nothing\s+Save the project/);
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });

    const found = await visitor.meshJson("mm");
    const refusals = await page.evaluate("refusals");
    await visitor.move("nose tip", "z", 9);
    const work = await visitor.meshJson("mm");
    assert.notDeepEqual(work, found);
    await page.waitForFunction((before) => globalThis.refusals > before, refusals);
    await visitor.frames(2);
    assert.ok(await page.isHidden("#notice"), "it is said again");
    const project = await visitor.download("save-project");
    await page.click("#toolbar [data-action='undo']");
    assert.deepEqual(await visitor.meshJson("mm"), found);
    await visitor.drop(project, "face.rosto");
    await visitor.untilFace();
    await page.waitForSelector("#history li", { state: "attached" });
    assert.deepEqual(await visitor.meshJson("mm"), work);
    assert.ok(await page.isHidden("#notice"), "it is said again");
  });
}

/** How far the nose tip was moved out, mm. */
async function noseOut(visitor) {
  await visitor.findLandmark("nose tip");
  return Number(await visitor.page.inputValue("#landmark-sliders [data-axis='z'] input[type=number]"));
}

/** Types a number and reloads in the same task, unless the page is to stay. */
async function typeAndGo(page, offset_mm, next, wait_ms = 0) {
  const field = "#landmark-sliders [data-axis='z'] input[type=number]";
  const gone = next === "reload" ? page.waitForEvent("framenavigated") : undefined;
  const typed = page.evaluate(
    async ({ field, offset_mm, next, wait_ms }) => {
      const input = document.querySelector(field);
      input.value = String(offset_mm);
      input.dispatchEvent(new Event("input"));
      input.dispatchEvent(new Event("change"));
      if (wait_ms > 0) await new Promise((resolve) => setTimeout(resolve, wait_ms));
      if (next === "reload") location.reload();
    },
    { field, offset_mm, next, wait_ms },
  );
  // A page that goes may take its answer along.
  await (gone ? Promise.all([gone, typed.catch(() => {})]) : typed);
}

/** Runs in the page, as everything below, and counts in `refusals`. */
function refuseByError() {
  globalThis.refusals = 0;
  IDBFactory.prototype.open = () => {
    globalThis.refusals += 1;
    const request = Object.create(IDBOpenDBRequest.prototype, {
      error: { value: new DOMException("A mutation operation was attempted on a database that did not allow mutations.", "InvalidStateError") },
      onerror: { value: null, writable: true },
      onsuccess: { value: null, writable: true },
      onblocked: { value: null, writable: true },
      onupgradeneeded: { value: null, writable: true },
    });
    setTimeout(() => request.onerror?.(new Event("error")));
    return request;
  };
}

function refuseByFullness() {
  globalThis.refusals = 0;
  IDBObjectStore.prototype.put = () => {
    globalThis.refusals += 1;
    throw new DOMException("The disk is full.", "QuotaExceededError");
  };
}
