import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { furthest } from "./meshes.mjs";
import { difference } from "./pixels.mjs";

/** @param {import("./visitor.mjs").Visitor} visitor @param {string} expression @param {number} perCent */
async function express(visitor, expression, perCent) {
  await visitor.reach(`[data-expression="${expression}"]`);
  const field = visitor.page.locator(`[data-expression="${expression}"] input[type=number]`);
  await field.fill(String(perCent));
  await field.press("Tab");
  await visitor.frames(3);
}

/** @param {import("./visitor.mjs").Visitor} visitor @param {string} expression */
async function stands(visitor, expression) {
  return Number(await visitor.page.inputValue(`[data-expression="${expression}"] input[type=number]`));
}

/** The description in a GLB. @param {Buffer} file */
const described = (file) => JSON.parse(file.subarray(20, 20 + file.readUInt32LE(12)).toString());

test("an expression is seen, undone, outlives a reload, and is a morph target by its name", { tag: "@eyes" }, async ({ editor, page }) => {
  const [rest, shape] = [await editor.view(), await editor.meshJson("mm")];
  await express(editor, "jawOpen", 60);
  assert.deepEqual(await editor.history(), ["Mouth open"]);
  const opened = await editor.view();
  assert.ok(difference(rest, opened) > 0.01, "the mouth does not open");
  const work = await editor.meshJson("mm");
  assert.ok(furthest(shape, work) > 5);

  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), shape);
  assert.equal(await stands(editor, "jawOpen"), 0);
  await page.click("#toolbar [data-action='redo']");
  await editor.comeBack();
  assert.deepEqual(await editor.meshJson("mm"), work);
  assert.equal(await stands(editor, "jawOpen"), 60);

  await editor.untilLoaded();
  await editor.unfold("section-export");
  await page.check("#export-expressions");
  const { meshes } = described(await editor.download("download-glb"));
  await page.waitForSelector("#verdict[data-verdict='valid']");
  const { targetNames } = meshes[0].extras;
  assert.equal(targetNames.length, meshes[0].primitives[0].targets.length);
  assert.equal(targetNames.length, await page.locator("[data-expression]").count());
  assert.equal(meshes[0].weights[targetNames.indexOf("jawOpen")], 0.6);
  assert.equal(meshes[0].weights.filter((weight) => weight !== 0).length, 1);
});

test("both sides go together or apart, and rest takes all back as one change", { tag: "@rare" }, async ({ editor, page }) => {
  const shape = await editor.meshJson("mm");
  await editor.unfold("section-expressions");
  await page.check("#expressions-both");
  await express(editor, "mouthSmileLeft", 50);
  assert.deepEqual(await editor.history(), ["Smile, right", "Smile, left"]);
  assert.ok(await page.isHidden("[data-expression='mouthSmileRight']"));
  await page.uncheck("#expressions-both");
  await express(editor, "mouthSmileRight", 20);
  assert.deepEqual([await stands(editor, "mouthSmileLeft"), await stands(editor, "mouthSmileRight")], [50, 20]);
  const smiling = await editor.meshJson("mm");
  await editor.unfold("section-expressions");
  await page.click("[data-action='come-to-rest']");
  assert.ok(furthest(shape, await editor.meshJson("mm")) < 1e-9);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), smiling);
});
