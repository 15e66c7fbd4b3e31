import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

test("work survives a reload, is offered again, and can move to another browser as a project", { tag: "@usual" }, async ({ open }) => {
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

test("the history lists the edits; keys switch them off and on, and its buttons undo, redo and reset", async ({ editor, page }) => {
  const start = await editor.meshJson("mm");
  await editor.move("nose tip", "z", 9);
  const nose = await editor.meshJson("mm");
  await editor.move("bottom of the chin", "y", -6);
  const both = await editor.meshJson("mm");
  const items = page.locator("#history .check");
  await expect(items).toHaveCount(2);

  await editor.reveal("#history");
  for (const [action, left] of [["undo", 1], ["redo", 2]]) {
    await page.click(`#section-history [data-action='${action}']`);
    await expect(items, "a press changes one edit").toHaveCount(left);
  }

  const entry = items.first().locator("input");
  for (const [isOn, mesh] of [[false, nose], [true, both]]) {
    await editor.reveal("#history");
    await entry.focus();
    await page.keyboard.press("Space");
    await expect(entry).toBeChecked({ checked: isOn });
    await expect(entry, "the entry loses the focus").toBeFocused();
    assert.deepEqual(await editor.meshJson("mm"), mesh);
  }
  await editor.reveal("#history");
  await page.click("#section-history [data-action='reset']");
  assert.deepEqual(await editor.work(), { mesh: start, history: [] });
  await page.click("#toolbar [data-action='undo']");
  await expect(items).toHaveCount(2);
  assert.deepEqual(await editor.meshJson("mm"), both);
});
