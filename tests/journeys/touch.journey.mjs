import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { way } from "./meshes.mjs";
import { difference } from "./pixels.mjs";

const NOSE_TIP = 1;
const LOWER_LIP = 17;
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

test("on a phone two fingers turn the face and pinch it larger, three move it, and one drags what it is on", async ({ open }) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.openFace();
  const touch = await page.context().newCDPSession(page);
  const at = await page.locator("#viewport").boundingBox();
  const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];
  const nose = () => visitor.landmarkPlace(NOSE_TIP);
  const eyes = async () => [await visitor.landmarkPlace(33), await visitor.landmarkPlace(263)];
  const apart = ([one, other]) => Math.hypot(one.x - other.x, one.y - other.y);
  const reset = () => page.click("#toolbar [data-action='reset-view']");

  const [rest, restEyes] = [await nose(), await eyes()];
  await stroke(touch, [[{ x: x - 30, y }, { x: x + 30, y }], [{ x: x + 20, y }, { x: x + 80, y }]]);
  const [turned, turnedEyes] = [await nose(), await eyes()];
  const [noseWent, eyesWent] = [turned.x - rest.x, turnedEyes[0].x - restEyes[0].x];
  assert.ok(noseWent > eyesWent + 4, `the nose went by ${noseWent}, an eye by ${eyesWent}`);
  await reset();
  await stroke(touch, [[{ x: x - 40, y }, { x: x + 40, y }], [{ x: x - 60, y }, { x: x + 60, y }]]);
  const closer = apart(await eyes()) / apart(restEyes);
  assert.ok(closer > 1.35 && closer < 1.75, `${closer} times as large`);
  await reset();
  const three = (dx, dy) => [-40, 0, 40].map((beside) => ({ x: x + beside + dx, y: y + dy }));
  await stroke(touch, [three(0, 0), three(20, 50)]);
  for (const [eye, place] of (await eyes()).entries()) {
    const [dx, dy] = [place.x - restEyes[eye].x, place.y - restEyes[eye].y];
    assert.ok(Math.hypot(dx - 20, dy - 50) < 8, `an eye went by ${dx}, ${dy}`);
  }
  await reset();
  assert.deepEqual(await visitor.history(), [], "fingers that look edit nothing");

  const tip = await nose();
  const before = await visitor.meshJson("mm");
  await stroke(touch, [[tip], [{ x: tip.x + 30, y: tip.y - 30 }]]);
  assert.deepEqual(await visitor.history(), ["nose tip · 1"]);
  const went = way(before, await visitor.meshJson("mm"), NOSE_TIP);
  assert.ok(went[0] > 2 && went[1] > 2, `it went by ${went}`);

  // Beside the arm of the gizmo that points up, where a finger can mean nothing else.
  await visitor.findLandmark(String(NOSE_TIP));
  const here = await visitor.tagged();
  const lifted = await visitor.meshJson("mm");
  await stroke(touch, [[{ x: here.x + 14, y: here.y - 52 }], [{ x: here.x + 44, y: here.y - 82 }]]);
  const along = way(lifted, await visitor.meshJson("mm"), NOSE_TIP);
  assert.ok(along[1] > 2 && Math.hypot(along[0], along[2]) < 1e-9, `it went by ${along}`);
});

test("on a phone a tap selects and a drag moves it, while a second finger changes how far that reaches", async ({ open }) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.openFace();
  const touch = await page.context().newCDPSession(page);
  const send = (type, touchPoints) => touch.send("Input.dispatchTouchEvent", { type, touchPoints });
  const lip = await visitor.landmarkPlace(LOWER_LIP);
  await stroke(touch, [[lip], [lip]]);
  assert.equal(await visitor.landmark(), LOWER_LIP);
  assert.deepEqual(await visitor.history(), [], "a tap moves nothing");

  // A finger is not exact: what is selected is taken from beside it.
  const radius = async () => Number(await page.inputValue("#radius input[type=number]"));
  const usual_mm = await radius();
  const beside = { x: lip.x - 16, y: lip.y + 12, id: 0 };
  await send("touchStart", [beside]);
  for (const down of [8, 16, 24]) await send("touchMove", [{ ...beside, y: beside.y + down }]);
  const held = { ...beside, y: beside.y + 24 };
  const second = (away) => ({ x: held.x + away, y: held.y, id: 1 });
  await send("touchStart", [held, second(60)]);
  for (const away of [80, 100, 120]) await send("touchMove", [held, second(away)]);
  await visitor.frames(3);
  const wide_mm = await radius();
  assert.ok(wide_mm > 1.6 * usual_mm, `${wide_mm} mm instead of ${usual_mm}`);
  assert.match(await page.innerText("#landmark-tag"), new RegExp(`within ${wide_mm} mm`));
  await send("touchEnd", [held]);
  await send("touchMove", [{ ...held, y: held.y + 8 }]);
  await send("touchEnd", []);
  assert.equal((await visitor.history()).length, 1, "the drag went on under the first finger");
  assert.equal(await visitor.landmark(), LOWER_LIP);
});

test("on a phone one finger beside the face turns it", { tag: "@eyes" }, async ({ open }) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.openFace();
  const touch = await page.context().newCDPSession(page);
  const at = await page.locator("#viewport").boundingBox();
  const start = await visitor.view();
  await stroke(touch, [[{ x: 12, y: at.y + at.height - 90 }], [{ x: 112, y: at.y + at.height - 90 }]]);
  assert.ok(difference(start, await visitor.view()) > 0.02, "one finger did not turn the face");
  assert.deepEqual(await visitor.history(), []);
});

test("on a phone the sheet leaves most of the face free, and nothing scrolls sideways at 360 px", async ({ open }) => {
  const visitor = await open({ ...PHONE, viewport: { width: 360, height: 740 } });
  const { page } = visitor;
  await visitor.openFace();
  const sheet = await page.locator("#panel").boundingBox();
  assert.ok(sheet.height <= 0.45 * 740 + 1, `the sheet is ${sheet.height} px high`);
  const size = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  assert.deepEqual(size, [360, 740], "the page itself scrolls");
  for (const tab of ["view", "export", "shape"]) {
    await page.click(`#tab-${tab}`);
    const overflow = await page.locator("#sections").evaluate((element) => element.scrollWidth - element.clientWidth);
    assert.equal(overflow, 0, `the ${tab} tab scrolls sideways`);
    assert.ok(await page.isVisible("#said"), `what is said to screen readers is not said on the ${tab} tab`);
  }
});

for (const [width, tag] of alike([360, 390, 820, 1024, 1280])) {
  test(`nothing floats over anything else at ${width} px`, { tag }, async ({ open }) => {
    const visitor = await open({ ...PHONE, viewport: { width, height: 800 } });
    const { page } = visitor;
    await visitor.openFace();
    for (const language of ["en", "pt"]) {
      await visitor.speak(language);
      const [toolbar, privacy, hint, panel] = await Promise.all(
        ["toolbar", "privacy", "hint", "panel"].map((id) => page.locator(`#${id}`).boundingBox()),
      );
      for (const [one, other] of [[toolbar, privacy], [hint, toolbar], [hint, privacy], [toolbar, panel], [hint, panel], [privacy, panel]]) {
        assert.ok(areApart(one, other), `${language}: ${JSON.stringify(one)} and ${JSON.stringify(other)}`);
      }
    }
  });
}

/** Whether two boxes have no point in common. */
function areApart(one, other) {
  const beside = one.x + one.width <= other.x || other.x + other.width <= one.x;
  return beside || one.y + one.height <= other.y || other.y + other.height <= one.y;
}

/** Moves fingers from place to place. @param {import("@playwright/test").CDPSession} touch @param {{ x: number, y: number }[][]} places */
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
