import assert from "node:assert/strict";
import { journey } from "./journey.mjs";
import { difference } from "./pixels.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

journey("on a phone one finger turns, two move and zoom, and a long press picks", async (open) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.dropSample();
  const touch = await page.context().newCDPSession(page);
  const at = await page.locator("#viewport").boundingBox();
  const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];

  const start = await visitor.view();
  await stroke(touch, [[{ x: 20, y: at.y + 40 }], [{ x: 120, y: at.y + 60 }]]);
  const turned = await visitor.view();
  assert.ok(difference(start, turned) > 0.02, "one finger did not turn the face");

  await stroke(touch, [[{ x: x - 20, y }, { x: x + 20, y }], [{ x: x - 70, y }, { x: x + 70, y }]]);
  assert.ok(difference(turned, await visitor.view()) > 0.02, "two fingers did not zoom");
  await page.click("#toolbar [data-action='reset-view']");

  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  await page.waitForFunction(() => document.getElementById("landmark-search").value !== "");
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
});

journey("on a phone the sheet leaves most of the face free, and nothing scrolls sideways at 360 px", async (open) => {
  const visitor = await open({ ...PHONE, viewport: { width: 360, height: 740 } });
  const { page } = visitor;
  await visitor.dropSample();
  const sheet = await page.locator("#panel").boundingBox();
  assert.ok(sheet.height <= 0.45 * 740 + 1, `the sheet is ${sheet.height} px high`);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  for (const tab of ["view", "export", "shape"]) {
    await page.click(`#tab-${tab}`);
    const overflow = await page.locator("#sections").evaluate((element) => element.scrollWidth - element.clientWidth);
    assert.equal(overflow, 0, `the ${tab} tab scrolls sideways`);
  }
});

/**
 * Moves fingers from place to place.
 *
 * @param {import("playwright-core").CDPSession} touch
 * @param {{ x: number, y: number }[][]} places
 */
async function stroke(touch, [from, to]) {
  const STEPS = 5;
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: from });
  for (let step = 1; step <= STEPS; step++) {
    const touchPoints = from.map((place, finger) => ({
      x: place.x + ((to[finger].x - place.x) * step) / STEPS,
      y: place.y + ((to[finger].y - place.y) * step) / STEPS,
    }));
    await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints });
  }
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}
