import assert from "node:assert/strict";
import { partsOfGlb } from "./changed-files.mjs";
import { test } from "./fixtures.mjs";
import { maxDisplacement } from "./meshes.mjs";
import { difference } from "./pixels.mjs";

test.use({ visit: { expert: true } });

/**
 * Number field of an expression, in per cent.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @param {string} expression
 */
function fieldOf({ page }, expression) {
  return page.locator(`#expression-${expression} .number-field`);
}

/** @param {import("./visitor.mjs").Visitor} visitor @param {string} expression @param {number} perCent */
async function express(visitor, expression, perCent) {
  await visitor.reveal(`#expression-${expression}`);
  await fieldOf(visitor, expression).fill(String(perCent));
  await fieldOf(visitor, expression).press("Tab");
  await visitor.frames(3);
}

test("an expression is visible, can be undone, survives a reload, and becomes a named morph target", { tag: ["@eyes", "@usual"] }, async ({ editor, page }) => {
  const [rest, shape] = [await editor.view(), await editor.meshJson("mm")];
  await express(editor, "jawOpen", 60);
  assert.deepEqual(await editor.history(), ["Mouth open"]);
  const opened = await editor.view();
  assert.ok(difference(rest, opened) > 0.01, "the mouth does not open");
  const work = await editor.meshJson("mm");
  assert.ok(maxDisplacement(shape, work) > 5);

  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), shape);
  assert.equal(await fieldOf(editor, "jawOpen").inputValue(), "0");
  await page.click("#toolbar [data-action='redo']");
  await editor.reloadAndResume();
  assert.deepEqual(await editor.meshJson("mm"), work);
  assert.equal(await fieldOf(editor, "jawOpen").inputValue(), "60");

  await editor.untilLoaded();
  await editor.unfold("section-export");
  await page.check("#export-expressions");
  const [{ extras, primitives, weights }] = partsOfGlb(await editor.download("download-glb")).json.meshes;
  await page.waitForSelector("#verdict[data-tone='success']");
  assert.equal(extras.targetNames.length, primitives[0].targets.length);
  assert.equal(extras.targetNames.length, await page.locator("[id^='expression-']").count());
  assert.deepEqual(extras.targetNames.filter((_, place) => weights[place] !== 0), ["jawOpen"]);
  assert.equal(weights[extras.targetNames.indexOf("jawOpen")], 0.6);
});
