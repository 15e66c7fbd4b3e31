import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

test.use({ visit: { expert: true } });

test("an edit without anchors, followed by other densities, does not break the page", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  await editor.unfold("section-advanced");
  await page.selectOption("#anchors", "pins");
  const box = await page.locator("#viewport").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  for (const density of ["1", "2", "0"]) {
    await editor.unfold("section-view");
    await page.selectOption("#density", density);
    await editor.frames(3);
    assert.equal(await page.inputValue("#density"), density);
    for (const [right, down] of [[0, 0], [30, -20], [-40, 30], [5, 45]]) await page.mouse.move(x + right, y + down, { steps: 3 });
    await page.mouse.click(x + 12, y + 20);
    await editor.drag({ x: x + 12, y: y + 20 }, { x: 25, y: -10 });
    await page.focus("#viewport");
    await page.keyboard.press("Control+z");
    await editor.frames(3);
  }
  editor.assertNoErrors();

  // Editing still works.
  await editor.findLandmark("bottom of the chin");
  await editor.reveal("#anchors");
  await page.selectOption("#anchors", "oval");
  const before = await editor.meshJson("mm");
  await editor.setOffset("y", -6);
  const edited = await editor.meshJson("mm");
  assert.notDeepEqual(edited.positions, before.positions);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), before);
  await page.click("#toolbar [data-action='redo']");
  assert.deepEqual(await editor.meshJson("mm"), edited);
});
