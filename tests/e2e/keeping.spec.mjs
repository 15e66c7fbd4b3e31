import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { untilKept } from "./kept.mjs";
import { refuseDatabase } from "./watches.mjs";

/** How far the selected landmark is moved out, mm. */
const NOSE_OUT = "#landmark-sliders [data-axis='z'] input[type=number]";

test("an edit a moment before a reload, or before the tab is closed, is kept", async ({ visitor, page }) => {
  await visitor.openFace();
  await visitor.move("nose tip", "z", 3);
  await untilKept(page);

  await typeAndReload(page, 7);
  await visitor.resume();
  assert.equal(await noseOut(visitor), 7);

  await untilKept(page);
  await page.fill(NOSE_OUT, "-5");
  await page.press(NOSE_OUT, "Enter");
  await page.close({ runBeforeUnload: true });
  const next = await visitor.anotherTab();
  await next.resume();
  assert.equal(await noseOut(next), -5);
  await next.page.click("#toolbar [data-action='undo']");
  assert.equal(await noseOut(next), 7);
});

test("an edit is kept however long before the reload it was made", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  // Around the pause after which the database is told, it has been asked and has not answered.
  for (const [place, wait_ms] of [185, 200, 205, 210, 220, 240].entries()) {
    await editor.findLandmark("nose tip");
    await typeAndReload(page, place + 2, wait_ms);
    await editor.resume();
    assert.equal(await noseOut(editor), place + 2, `${wait_ms} ms`);
  }
});

const REFUSALS = Object.entries({ throws: refuseDatabase, "answers with an error": refuseByError, "is full": refuseByFullness });
for (const [[how, refuse], tag] of alike(REFUSALS)) {
  test(`where the database ${how}, the page says once that nothing is kept, and the work goes on`, { tag }, async ({ open }) => {
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
  return Number(await visitor.page.inputValue(NOSE_OUT));
}

/** Types a number, and reloads in the same task or after a while. */
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
  // A page that goes may take its answer along.
  await Promise.all([page.waitForEvent("framenavigated"), typed.catch(() => {})]);
}

/** Runs in the page, as everything below, and counts in `refusals`. */
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
