import assert from "node:assert/strict";
import { PAGE_EDIT_OPTIONS, meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { assertPortraitColours } from "./portrait-colours.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

test("a dropped portrait becomes a mesh in its colours, and a click selects a point", { tag: ["@eyes", "@usual"] }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await assertPortraitColours(await visitor.view());
  await visitor.selectBy("landmark");
  await page.click("#viewport");
  assert.match(await page.inputValue("#landmark-search"), / · \d+$/);
  assert.ok(await page.isVisible("#landmark-tag"));
});

test("moving the nose tip changes picture and mesh like the command line, and undo restores both", { tag: ["@eyes", "@usual"] }, async ({ editor }) => {
  await editor.choosePreset("paper");
  await editor.unfold("section-view");
  await editor.page.click("[data-action='view.left']");
  await editor.findLandmark("nose tip");
  const before = { view: await editor.viewWithoutMarks(), mesh: await editor.meshJson("mm") };
  await editor.setOffset("z", 12);
  const anchors = await editor.anchors();
  assert.equal(anchors.length, 2);
  const after = { view: await editor.viewWithoutMarks(), mesh: await editor.meshJson("mm") };
  assert.ok(difference(before.view, after.view) > 0.002, "the picture did not change");

  const edit = `${await editor.selectedLandmark()}:0,0,12:${anchors.join(",")}`;
  const options = ["--units", "mm", "--density", "0"];
  assertSameMesh(before.mesh, await meshByCommandLine(SAMPLE, options));
  assertSameMesh(after.mesh, await meshByCommandLine(SAMPLE, [...options, "--edit", edit]));

  await editor.page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), before.mesh);
  assert.equal(difference(before.view, await editor.viewWithoutMarks()), 0, "undo left the picture changed");
  await editor.page.click("#toolbar [data-action='redo']");
  assert.deepEqual(await editor.meshJson("mm"), after.mesh);
});

test("rotating details follow each tick and give the command line's mesh", { tag: "@eyes" }, async ({ editor }) => {
  await editor.findLandmark("61");
  await editor.unfold("section-advanced");
  await editor.page.selectOption("#details", "turned");
  const before = await editor.view();
  await editor.page.fill("#landmark-offset [data-axis='z'] .number-field", "14");
  assert.ok(difference(before, await editor.view()) > 0.002, "the picture did not change while the number was typed");
  await editor.page.press("#landmark-offset [data-axis='z'] .number-field", "Tab");
  const options = [...PAGE_EDIT_OPTIONS, "--edit", "61:0,0,14"];
  const turned = await meshByCommandLine(SAMPLE, [...options, "--turn-details"]);
  assertSameMesh(await editor.meshJson("mm"), turned);
  const kept = await meshByCommandLine(SAMPLE, options);
  assert.throws(() => assertSameMesh(kept, turned), "details that keep their direction make the same mesh");
});
