import assert from "node:assert/strict";
import { journey } from "./journey.mjs";
import { way } from "./meshes.mjs";
import { difference } from "./pixels.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

journey("on a phone two fingers move the face with them and pinch it larger, and a finger drags what it has picked", async (open) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.dropSample();
  const touch = await page.context().newCDPSession(page);
  const at = await page.locator("#viewport").boundingBox();
  const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];
  const places = async () => {
    const found = [];
    for (const landmark of ["33", "263"]) {
      await visitor.findLandmark(landmark);
      found.push(await visitor.tagged());
    }
    return found;
  };
  const apart = ([one, other]) => Math.hypot(one.x - other.x, one.y - other.y);

  const start = await places();
  await stroke(touch, [[{ x: x - 30, y }, { x: x + 30, y }], [{ x: x - 10, y: y + 50 }, { x: x + 50, y: y + 50 }]]);
  const moved = await places();
  for (const [eye, place] of moved.entries()) {
    const [dx, dy] = [place.x - start[eye].x, place.y - start[eye].y];
    assert.ok(Math.hypot(dx - 20, dy - 50) < 6, `an eye went by ${dx}, ${dy}`);
  }
  await stroke(touch, [[{ x: x - 40, y }, { x: x + 40, y }], [{ x: x - 60, y }, { x: x + 60, y }]]);
  const closer = apart(await places()) / apart(moved);
  assert.ok(closer > 1.35 && closer < 1.75, `${closer} times as large`);
  await page.click("#toolbar [data-action='reset-view']");

  await visitor.reach("#mirror");
  await page.uncheck("#mirror");
  await visitor.findLandmark("nose tip");
  const tip = await visitor.tagged();
  const before = await visitor.meshJson("mm");
  await stroke(touch, [[tip], [{ x: tip.x + 30, y: tip.y - 30 }]]);
  assert.deepEqual(await visitor.history(), ["nose tip · 1"]);
  const went = way(before, await visitor.meshJson("mm"), 1);
  assert.ok(went[0] > 2 && went[1] > 2, `it went by ${went}`);

  // Beside the arm of the gizmo that points up, where a finger can mean nothing else.
  const here = await visitor.tagged();
  const lifted = await visitor.meshJson("mm");
  await stroke(touch, [[{ x: here.x + 14, y: here.y - 52 }], [{ x: here.x + 44, y: here.y - 82 }]]);
  const along = way(lifted, await visitor.meshJson("mm"), 1);
  assert.ok(along[1] > 2 && Math.hypot(along[0], along[2]) < 1e-9, `it went by ${along}`);
});

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
  const picked = await page.inputValue("#landmark-search");
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.equal(await page.inputValue("#landmark-search"), picked);
  await visitor.reach("#selection");
  await page.check("input[name='selection'][value='region']", { force: true });
  const region = await page.inputValue("#region");
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  await page.waitForFunction((region) => document.getElementById("region").value !== region, region);
  const larger = await page.inputValue("#region");
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.equal(await page.inputValue("#region"), larger, "lifting the finger picked once more");

  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  await page.waitForFunction((larger) => document.getElementById("region").value !== larger, larger);
  for (const up of [10, 20, 30]) {
    await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x, y: y - up }] });
  }
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.equal((await visitor.history()).length, 1, "what a held finger picked did not follow it");
}, { needs: "eyes" });

journey("on a phone the sheet leaves most of the face free, and nothing scrolls sideways at 360 px", async (open) => {
  const visitor = await open({ ...PHONE, viewport: { width: 360, height: 740 } });
  const { page } = visitor;
  await visitor.dropSample();
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

for (const width of [360, 390, 820, 1024, 1280]) {
  journey(`nothing floats over anything else at ${width} px`, async (open) => {
    const visitor = await open({ ...PHONE, viewport: { width, height: 800 } });
    const { page } = visitor;
    await visitor.dropSample();
    for (const language of ["en", "pt"]) {
      await page.evaluate((language) => {
        const choice = document.getElementById("language");
        choice.value = language;
        choice.dispatchEvent(new Event("change"));
      }, language);
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
