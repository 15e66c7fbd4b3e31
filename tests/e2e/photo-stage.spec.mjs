import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference, differenceNear } from "./pixels.mjs";

/** @param {import("./visitor.mjs").Visitor} visitor */
const scene = (visitor) => visitor.page.evaluate(() => document.body.dataset.scene);

/** @param {import("./visitor.mjs").Visitor} visitor */
async function photoOnStage(visitor) {
  await visitor.openFace();
  await visitor.page.focus("#viewport");
  // By key, so that the view has the focus.
  await visitor.page.keyboard.press("p");
  await visitor.frames(5);
}

test("a click on the thumbnail opens the photo on the stage; the switch and P return, a drag moves it, and the choice is saved", { tag: "@eyes" }, async ({ editor }) => {
  assert.equal(await scene(editor), "solid", "the 3D face is not the initial scene");
  const solid = await editor.view();
  await editor.page.click("#photo-to-stage");
  assert.equal(await scene(editor), "picture");
  const photo = await editor.view();
  assert.ok(difference(solid, photo) > 0.5, "the stage has not changed");
  await editor.page.check("#scene input[value='solid']", { force: true });
  assert.equal(difference(solid, await editor.view()), 0);
  await editor.page.keyboard.press("p");
  assert.equal(await scene(editor), "picture");
  assert.equal(difference(photo, await editor.view()), 0);
  await editor.drag(await editor.emptyPoint(), { x: 80, y: 0 });
  assert.equal(await scene(editor), "picture");
  assert.ok(difference(photo, await editor.view()) > 0.01, "the photo does not follow the drag");
  assert.deepEqual(await editor.history(), []);
  await editor.reloadAndResume();
  assert.equal(await scene(editor), "picture");
});

test("a point can be dragged on the photo, which changes only there", { tag: ["@eyes", "@usual"] }, async ({ visitor }) => {
  await photoOnStage(visitor);
  const nose = await visitor.landmarkPosition(4);
  await visitor.drag(nose, { x: 0, y: -24 });
  assert.equal(await scene(visitor), "picture");
  assert.equal((await visitor.history()).length, 1);
  await visitor.page.focus("#viewport");
  await visitor.page.keyboard.press("Escape");
  await visitor.page.mouse.move(1, 1);
  const edited = await visitor.view();
  await visitor.page.keyboard.press("Control+z");
  const found = await visitor.view();
  assert.ok(differenceNear(found, edited, await visitor.toViewPixels(nose), 40) > 0.1, "the nose has not moved");
  assert.equal(differenceNear(found, edited, { x: 40, y: 40 }, 35), 0, "a corner of the photo has changed");
  await visitor.page.keyboard.press("Control+Shift+z");
  assert.equal(difference(edited, await visitor.view()), 0, "redo does not restore the edit");
});

test("sliders, regions and the comparison work on the photo", { tag: "@eyes" }, async ({ visitor }) => {
  await photoOnStage(visitor);
  const before = await visitor.view();
  await visitor.setSlider("eye-size", 2);
  await visitor.selectRegion("nose");
  await visitor.setOffset("y", 4);
  await visitor.page.focus("#viewport");
  await visitor.page.keyboard.press("Escape");
  const after = await visitor.view();
  assert.ok(difference(before, after) > 0.005);
  await visitor.page.keyboard.down("b");
  assert.equal(difference(before, await visitor.view()), 0, "B does not show the original photo");
  await visitor.page.keyboard.up("b");
  await visitor.page.click("#compare");
  const wiped = await visitor.view();
  assert.ok(difference(wiped, before) > 0 && difference(wiped, after) > 0, "the comparison does not show both");
});

test("the thumbnail shows edits while they are made", async ({ editor }) => {
  await editor.frames(4);
  const small = async () => PNG.sync.read(await editor.page.locator("#photo-thumbnail").screenshot());
  const before = await small();
  await editor.page.locator("#slider-jaw-width input[type=range]").evaluate((slider) => {
    slider.value = slider.min;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await editor.frames(4);
  assert.ok(difference(before, await small()) > 0.02, "the thumbnail does not change during the drag");
  await editor.page.keyboard.press("Escape");
});

test("wide windows show photo and 3D face next to each other, and a click on the photo opens it on the stage", async ({ open }) => {
  const visitor = await open({ viewport: { width: 1440, height: 900 } });
  await visitor.openFace();
  await visitor.frames(4);
  const seen = await visitor.page.evaluate(() => {
    const photo = document.getElementById("photo-pane").getBoundingClientRect();
    const stage = document.getElementById("viewport").getBoundingClientRect();
    return { share: photo.width / stage.width, width: document.getElementById("photo-pane-canvas").width };
  });
  assert.ok(seen.share > 0.4 && seen.share < 0.55 && seen.width > 150, JSON.stringify(seen));
  const nose = await visitor.landmarkPosition(4);
  assert.ok(nose.x > 1080 / 2, "the 3D face is not in the other half");
  await visitor.page.click("#photo-pane");
  assert.equal(await scene(visitor), "picture");
  await visitor.page.setViewportSize({ width: 800, height: 900 });
  await visitor.page.keyboard.press("p");
  assert.ok(!(await visitor.page.isVisible("#photo-pane")), "a narrow window shows both");
  await visitor.page.setViewportSize({ width: 1440, height: 900 });
  await visitor.page.waitForSelector("#photo-pane");
  await visitor.page.click("#split-view");
  assert.ok(!(await visitor.page.isVisible("#photo-pane")));
  await visitor.reloadAndResume();
  assert.ok(!(await visitor.page.isVisible("#photo-pane")), "the choice is forgotten");
});

test("areas protected by the brush stay unchanged and have separate undo", async ({ visitor }) => {
  await photoOnStage(visitor);
  const photo = async () => PNG.sync.read(await visitor.download("download-photo-png"));
  const isOff = (/** @type {string} */ button) => visitor.page.isDisabled(button);
  await visitor.setSlider("jaw-width", -8);
  const jaw = await visitor.landmarkPosition(172);
  const edited = await photo();
  await visitor.unfold("section-in-photo");
  await visitor.page.check("#brush", { force: true });
  await visitor.drag({ x: jaw.x - 10, y: jaw.y - 30 }, { x: 10, y: 60 });
  assert.deepEqual([await isOff("#brush-undo"), await isOff("#brush-redo")], [false, true]);
  await visitor.page.uncheck("#brush", { force: true });
  const kept = await photo();
  assert.ok(difference(edited, kept) > 0.0005, "the protected area follows the edit");
  assert.deepEqual(await visitor.history(), ["Jaw width"], "the stroke is in the history");
  await visitor.unfold("section-in-photo");
  await visitor.page.check("#brush", { force: true });
  await visitor.page.focus("#viewport");
  await visitor.page.keyboard.press("Control+z");
  assert.deepEqual([await isOff("#brush-undo"), await isOff("#brush-redo")], [true, false]);
  await visitor.page.uncheck("#brush", { force: true });
  assert.equal(difference(edited, await photo()), 0);
  assert.deepEqual(await visitor.history(), ["Jaw width"]);
});
