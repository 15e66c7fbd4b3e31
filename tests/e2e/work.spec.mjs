import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test("work survives a reload, is offered again, and can move to another browser as a project", async ({ open }) => {
  const first = await open();
  await first.dropSample();
  await first.move("nose tip", "z", 9);
  const work = await first.meshJson("mm");
  const file = await first.download("save-project");
  await first.reloadAndResume();
  assert.deepEqual(await first.meshJson("mm"), work);
  await first.page.click("#toolbar [data-action='undo']");
  assert.notDeepEqual(await first.meshJson("mm"), work);

  const second = await open();
  await second.drop(file, "face.rosto");
  await second.untilFace();
  await second.page.waitForSelector("#history .check", { state: "attached" });
  assert.deepEqual(await second.meshJson("mm"), work);

  await second.drop(file.subarray(0, 2000), "half.rosto");
  assert.equal((await second.notice()).code, "bad-project");
  assert.deepEqual(await second.meshJson("mm"), work);
});

test("the history lists the edits, and each can be switched off and on", async ({ editor, page }) => {
  const start = await editor.meshJson("mm");
  await editor.move("nose tip", "z", 9);
  const nose = await editor.meshJson("mm");
  await editor.move("bottom of the chin", "y", -6);
  const both = await editor.meshJson("mm");
  const items = page.locator("#history .check");
  await expect(items).toHaveCount(2);

  for (const [isOn, mesh] of [[false, nose], [true, both]]) {
    await editor.reveal("#history");
    await items.first().locator("input").setChecked(isOn);
    assert.deepEqual(await editor.meshJson("mm"), mesh);
  }
  await editor.reveal("#history");
  await page.click("#section-history [data-action='reset']");
  assert.deepEqual(await editor.work(), { mesh: start, history: [] });
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), both);
  await expect(items).toHaveCount(2);
});

test("holding B shows the original face", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  await page.focus("#viewport");
  await page.keyboard.press("l");
  const before = await editor.view();
  await editor.setOffset("z", 12);
  await page.focus("#viewport");
  // The marks of a selected point would fade between the pictures.
  await page.keyboard.press("Escape");
  const after = await editor.view();
  await page.keyboard.down("b");
  const held = await editor.view();
  await page.keyboard.up("b");
  const released = await editor.view();
  assert.ok(difference(before, after) > 0.002);
  assert.ok(difference(after, released) === 0, "releasing the key did not restore the edit");
  assert.ok(difference(before, held) < difference(after, held), "the key did not show the original face");
});
