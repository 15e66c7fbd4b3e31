import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { untilSaved } from "./storage.mjs";
import { refuseDatabase } from "./page-scripts.mjs";

/** Number field of the selected landmark's z offset, in mm. */
const NOSE_OUT = "#landmark-offset [data-axis='z'] .number-field";

test("an edit just before a reload or before closing the tab is saved", async ({ visitor, page }) => {
  await visitor.openFace();
  await visitor.move("nose tip", "z", 3);
  await untilSaved(page);

  await typeAndReload(page, 7);
  await visitor.resume();
  assert.equal(await noseOut(visitor), 7);

  await untilSaved(page);
  await page.fill(NOSE_OUT, "-5");
  await page.press(NOSE_OUT, "Enter");
  await page.close({ runBeforeUnload: true });
  const next = await visitor.openTab();
  await next.resume();
  assert.equal(await noseOut(next), -5);
  await next.page.click("#toolbar [data-action='undo']");
  assert.equal(await noseOut(next), 7);
});

test("an edit is saved at any time before a reload", async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  // Around the debounce delay, the database has been asked and has not answered.
  for (const [place, wait_ms] of [185, 200, 205, 210, 220, 240].entries()) {
    await editor.findLandmark("nose tip");
    await typeAndReload(page, place + 2, wait_ms);
    await editor.resume();
    assert.equal(await noseOut(editor), place + 2, `${wait_ms} ms`);
  }
});

const REFUSALS = Object.entries({ throws: refuseDatabase, "answers with an error": refuseByError, "is full": refuseByFullness });
for (const [how, refuse] of REFUSALS) {
  test(`if the database ${how}, a notice says once that work cannot be saved, and editing continues`, async ({ open }) => {
    const visitor = await open({ scripts: [refuse] });
    const { page } = visitor;
    await visitor.openFace();
    await page.waitForSelector("#notice[data-code='not-kept']");
    assert.match((await visitor.notice()).text, /can’t be saved in this browser\s+Save the project/);
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });

    const found = await visitor.meshJson("mm");
    const refusals = await page.evaluate("refusals");
    await visitor.move("nose tip", "z", 9);
    const work = await visitor.meshJson("mm");
    assert.notDeepEqual(work, found);
    await page.waitForFunction((before) => globalThis.refusals > before, refusals);
    await visitor.frames(2);
    assert.ok(await page.isHidden("#notice"), "the notice is repeated");
    const project = await visitor.download("save-project");
    await page.click("#toolbar [data-action='undo']");
    assert.deepEqual(await visitor.meshJson("mm"), found);
    await visitor.drop(project, "face.rosto");
    await visitor.untilFace();
    await page.waitForSelector("#history .check", { state: "attached" });
    assert.deepEqual(await visitor.meshJson("mm"), work);
    assert.ok(await page.isHidden("#notice"), "the notice is repeated");
  });
}

/** z offset of the nose tip, in mm. */
async function noseOut(visitor) {
  await visitor.findLandmark("nose tip");
  return Number(await visitor.page.inputValue(NOSE_OUT));
}

/** Enters a number and reloads, immediately or after a delay. */
async function typeAndReload(page, offset_mm, wait_ms = 0) {
  const typed = page.locator(NOSE_OUT).evaluate(
    async (input, { offset_mm, wait_ms }) => {
      input.value = String(offset_mm);
      for (const type of ["input", "change"]) input.dispatchEvent(new Event(type));
      if (wait_ms > 0) await new Promise((resolve) => setTimeout(resolve, wait_ms));
      location.reload();
    },
    { offset_mm, wait_ms },
  );
  // A reload may discard the result.
  await Promise.all([page.waitForEvent("framenavigated"), typed.catch(() => {})]);
}

/** Runs in the page; counts attempts in `refusals`. */
function refuseByError() {
  globalThis.refusals = 0;
  IDBFactory.prototype.open = () => {
    globalThis.refusals += 1;
    const request = { error: new DOMException("A mutation was attempted on a database that allows none.", "InvalidStateError") };
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
