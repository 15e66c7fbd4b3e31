import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test("the work survives a reload and is offered again", async ({ visitor }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.meshJson("mm");
  await visitor.comeBack();
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.page.click("#toolbar [data-action='undo']");
  assert.notDeepEqual(await visitor.meshJson("mm"), work);
});

test("a project file brings the face and its edits to another browser", async ({ open }) => {
  const first = await open();
  await first.openFace();
  await first.move("nose tip", "y", -5);
  const work = await first.meshJson("mm");
  const file = await first.download("save-project");

  const second = await open();
  await second.drop(file, "face.rosto");
  await second.untilFace();
  await second.page.waitForSelector("#history li");
  assert.deepEqual(await second.meshJson("mm"), work);

  await second.drop(file.subarray(0, 2000), "half.rosto");
  assert.equal((await second.notice()).code, "bad-project");
  assert.deepEqual(await second.meshJson("mm"), work);
});

test("history lists the edits, and each can be switched off and on", async ({ editor, page }) => {
  const start = await editor.meshJson("mm");
  await editor.move("nose tip", "z", 9);
  const nose = await editor.meshJson("mm");
  await editor.move("bottom of the chin", "y", -6);
  const both = await editor.meshJson("mm");
  assert.equal(await page.locator("#history li").count(), 2);

  const newest = page.locator("#history li input").first();
  await editor.reach("#history");
  await newest.uncheck();
  assert.deepEqual(await editor.meshJson("mm"), nose);
  await editor.reach("#history");
  await page.locator("#history li input").first().check();
  assert.deepEqual(await editor.meshJson("mm"), both);
  await editor.reach("#history");
  await page.click("#section-history [data-action='reset']");
  assert.deepEqual(await editor.meshJson("mm"), start);
  assert.deepEqual(await editor.history(), []);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), both);
  assert.equal(await page.locator("#history li").count(), 2);
});

test("a key held down shows the face as it was found", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  await page.focus("#viewport");
  await page.keyboard.press("l");
  const before = await editor.view();
  await editor.offset("z", 12);
  await page.focus("#viewport");
  const after = await editor.view();
  await page.keyboard.down("b");
  const held = await editor.view();
  await page.keyboard.up("b");
  const released = await editor.view();
  assert.ok(difference(before, after) > 0.002);
  assert.ok(difference(after, released) === 0, "letting go did not bring the edit back");
  assert.ok(difference(before, held) < difference(after, held), "the held key did not show the face as it was found");
});
