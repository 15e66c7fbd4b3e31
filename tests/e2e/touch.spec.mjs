import assert from "node:assert/strict";
import { findings } from "./boxes.mjs";
import { test } from "./fixtures.mjs";
import { displacement } from "./meshes.mjs";

const NOSE_TIP = 1;
const LOWER_LIP = 17;

test.use({ visit: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 } });

test("on a phone, fingers turn, zoom, pan and drag", async ({ editor, page }) => {
  const send = await toucher(page);
  const at = await page.locator("#viewport").boundingBox();
  const [x, y] = [at.x + at.width / 2, at.y + at.height / 2];
  const nose = () => editor.landmarkPosition(NOSE_TIP);
  const eyes = async () => [await editor.landmarkPosition(33), await editor.landmarkPosition(263)];
  const apart = ([one, other]) => Math.hypot(one.x - other.x, one.y - other.y);
  const reset = () => page.click("#toolbar [data-action='reset-view']");
  const row = (...places) => places.map((beside) => ({ x: x + beside, y }));

  const [rest, restEyes] = [await nose(), await eyes()];
  for (const fingers of [row(-30, 30), [{ x: 12, y: at.y + at.height - 90 }]]) {
    await stroke(send, fingers, shifted(fingers, 50, 0));
    const [noseWent, eyesWent] = [(await nose()).x - rest.x, (await eyes())[0].x - restEyes[0].x];
    assert.ok(noseWent > eyesWent + 4, `${fingers.length} fingers: the nose went by ${noseWent}, an eye by ${eyesWent}`);
    await reset();
  }
  await stroke(send, row(-40, 40), row(-60, 60));
  const closer = apart(await eyes()) / apart(restEyes);
  assert.ok(closer > 1.35 && closer < 1.75, `${closer} times as large`);
  await reset();
  await stroke(send, row(-40, 0, 40), shifted(row(-40, 0, 40), 20, 50));
  for (const [eye, place] of (await eyes()).entries()) {
    const [dx, dy] = [place.x - restEyes[eye].x, place.y - restEyes[eye].y];
    assert.ok(Math.hypot(dx - 20, dy - 50) < 8, `an eye went by ${dx}, ${dy}`);
  }
  await reset();
  assert.deepEqual(await editor.history(), [], "view gestures made an edit");

  const tip = await nose();
  const before = await editor.meshJson("mm");
  await stroke(send, [tip], shifted([tip], 30, -30));
  assert.deepEqual(await editor.history(), ["nose tip"]);
  const went = displacement(before, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(went[0] > 2 && went[1] > 2, `it went by ${went}`);

  // Next to the gizmo's upward arm, where a touch is unambiguous.
  const arm = shifted([await nose()], 6, -52);
  const lifted = await editor.meshJson("mm");
  // The arms fade, so the point is selected again.
  await editor.findLandmark(String(NOSE_TIP));
  await stroke(send, arm, shifted(arm, 30, -30));
  const along = displacement(lifted, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(along[1] > 2 && Math.hypot(along[0], along[2]) < 1e-9, `it went by ${along}`);
});

test("on a phone a tap selects, a drag moves, and a second finger changes the influence radius", { tag: "@usual" }, async ({ editor, page }) => {
  const send = await toucher(page);
  const lip = await editor.landmarkPosition(LOWER_LIP);
  await stroke(send, [lip], [lip]);
  assert.equal(await editor.selectedLandmark(), LOWER_LIP);
  assert.deepEqual(await editor.history(), [], "a tap made an edit");

  // Touch is inexact, so a press near the selection grabs it.
  const radius = async () => Number(await page.inputValue("#edit-radius .number-field"));
  const usual_mm = await radius();
  const beside = { x: lip.x - 16, y: lip.y + 12, id: 0 };
  await send("touchStart", [beside]);
  for (const down of [8, 16, 24]) await send("touchMove", [{ ...beside, y: beside.y + down }]);
  const held = { ...beside, y: beside.y + 24 };
  const second = (away) => ({ x: held.x + away, y: held.y, id: 1 });
  await send("touchStart", [held, second(60)]);
  for (const away of [80, 100, 120]) await send("touchMove", [held, second(away)]);
  await editor.frames(3);
  const wide_mm = await radius();
  assert.ok(wide_mm > 1.6 * usual_mm, `${wide_mm} mm instead of ${usual_mm}`);
  assert.match(await page.innerText("#landmark-tag"), new RegExp(`within ${wide_mm} mm`));
  await send("touchEnd", [held]);
  await send("touchMove", [{ ...held, y: held.y + 8 }]);
  await send("touchEnd", []);
  assert.equal((await editor.history()).length, 1, "the drag did not continue with the first finger");
  assert.equal(await editor.selectedLandmark(), LOWER_LIP);
});

test("on a phone the bottom sheet leaves most of the face visible, without overlaps or horizontal scrolling", { tag: "@usual" }, async ({ open }) => {
  const narrow = { width: 360, height: 740 };
  const visitor = await open({ viewport: narrow });
  const { page } = visitor;
  await visitor.openFace();
  const sheet = await page.locator("#panel").boundingBox();
  assert.ok(sheet.height <= 0.45 * 740 + 1, `the sheet is ${sheet.height} px high`);
  const size = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
  assert.deepEqual(size, [360, 740], "the page itself scrolls");
  for (const viewport of [{ width: 1024, height: 800 }, narrow]) {
    await page.setViewportSize(viewport);
    for (const language of ["pt", "en"]) {
      await visitor.setLanguage(language);
      assert.ok(await page.isVisible("#hint"));
      assert.deepEqual(await findings(page), [], `${viewport.width} px, ${language}`);
    }
  }
  for (const tab of ["view", "export", "shape"]) {
    await page.click(`#tab-${tab}`);
    assert.deepEqual(await findings(page), [], tab);
    assert.ok(await page.isVisible("#announcement"), `the live region is hidden on the ${tab} tab`);
  }
});

test("on the photo, a pinch zooms about the fingers, two fingers pan, and a double tap fits", async ({ editor, page }) => {
  const send = await toucher(page);
  const nose = () => editor.landmarkPosition(NOSE_TIP);
  const scene = () => page.getAttribute("body", "data-scene");
  await page.check("#toolbar input[value='picture']", { force: true });
  const rest = await nose();
  const around = (apart) => [{ x: rest.x - apart, y: rest.y }, { x: rest.x + apart, y: rest.y }];
  const eyes = async () => (await editor.landmarkPosition(263)).x - (await editor.landmarkPosition(33)).x;
  const before = await eyes();
  await stroke(send, around(40), around(80));
  const zoomed = await nose();
  const larger = (await eyes()) / before;
  assert.ok(larger > 1.7 && larger < 2.3, `${larger} times as large`);
  assert.ok(Math.hypot(zoomed.x - rest.x, zoomed.y - rest.y) < 12, `the nose moved to ${zoomed.x}, ${zoomed.y}`);
  await stroke(send, around(40), shifted(around(40), 30, -20));
  const panned = await nose();
  assert.ok(Math.hypot(panned.x - zoomed.x - 30, panned.y - zoomed.y + 20) < 12, `it moved by ${panned.x - zoomed.x}, ${panned.y - zoomed.y}`);
  assert.equal(await scene(), "picture");
  const empty = { x: 20, y: rest.y };
  for (let tap = 0; tap < 2; tap += 1) await stroke(send, [empty], [empty]);
  const fitted = await nose();
  assert.ok(Math.hypot(fitted.x - rest.x, fitted.y - rest.y) < 1, `the nose is at ${fitted.x}, ${fitted.y}`);
  assert.equal(await scene(), "picture");
});

test("on a phone, targets are at least 44 px large", async ({ editor }) => {
  const { page } = editor;
  for (const tab of ["shape", "view", "export"]) {
    await page.click(`#tab-${tab}`);
    const small = await page.evaluate(() => {
      const targets = [...document.querySelectorAll("button, input:not([type=file]), select, summary, a")].filter((one) => one.checkVisibility());
      // The label of a checkbox or radio is the target.
      const boxes = targets.map((one) => [one, (one.matches("[type=checkbox], [type=radio], [type=color]") ? one.closest("label") : one)?.getBoundingClientRect()]);
      const isSmall = ({ width, height }) => width > 1 && (width < 43.5 || height < 43.5);
      return boxes.filter(([, box]) => box && isSmall(box)).map(([one, { width, height }]) => `${one.id || one.className}: ${width} × ${height}`);
    });
    assert.deepEqual(small, [], tab);
  }
});

test("the handle makes the sheet taller, by a press and by dragging", async ({ editor, page }) => {
  const height = async () => (await page.locator("#panel").boundingBox()).height;
  const before = await height();
  await page.click("#sheet-handle");
  assert.ok((await height()) > 0.8 * 844);
  const handle = await page.locator("#sheet-handle").boundingBox();
  const send = await toucher(page);
  const start = [{ x: 195, y: handle.y + 10 }];
  await stroke(send, start, shifted(start, 0, 300));
  assert.equal(await height(), before);
  assert.ok(await page.isVisible("#save-main"), "the main button is out of reach");
  assert.deepEqual(await editor.history(), []);
});

/** A function that sends touch events. @param {import("@playwright/test").Page} page */
async function toucher(page) {
  const session = await page.context().newCDPSession(page);
  return (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
}

/** Moves fingers from one set of positions to another. @param {Awaited<ReturnType<typeof toucher>>} send */
async function stroke(send, from, to) {
  await send("touchStart", from);
  for (const share of [0.2, 0.4, 0.6, 0.8, 1]) {
    const between = (finger, axis) => from[finger][axis] + share * (to[finger][axis] - from[finger][axis]);
    await send("touchMove", from.map((_, finger) => ({ x: between(finger, "x"), y: between(finger, "y") })));
  }
  await send("touchEnd", []);
}

function shifted(places, dx, dy) {
  return places.map(({ x, y }) => ({ x: x + dx, y: y + dy }));
}
