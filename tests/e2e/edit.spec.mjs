import assert from "node:assert/strict";
import { PAGE_EDIT_OPTIONS, meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { assertPortraitColours } from "./portrait-colours.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

test("a dropped portrait becomes a mesh in its colours, and a click selects a point", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await assertPortraitColours(await visitor.view());
  await visitor.selectBy("landmark");
  await page.click("#viewport");
  assert.match(await page.inputValue("#landmark-search"), / · \d+$/);
  assert.ok(await page.isVisible("#landmark-tag"));
});

test("moving the nose tip changes picture and mesh like the command line, and undo restores both", { tag: "@eyes" }, async ({ editor }) => {
  await editor.choosePreset("paper");
  await editor.unfold("section-view");
  await editor.page.click("[data-action='view.left']");
  await editor.findLandmark("nose tip");
  const before = { view: await editor.view(), mesh: await editor.meshJson("mm") };
  await editor.setOffset("z", 12);
  const anchors = await editor.anchors();
  assert.equal(anchors.length, 2);
  const after = { view: await editor.view(), mesh: await editor.meshJson("mm") };
  assert.ok(difference(before.view, after.view) > 0.002, "the picture did not change");

  const edit = `${await editor.selectedLandmark()}:0,0,12:${anchors.join(",")}`;
  const options = ["--units", "mm", "--density", "0"];
  assertSameMesh(before.mesh, await meshByCommandLine(SAMPLE, options));
  assertSameMesh(after.mesh, await meshByCommandLine(SAMPLE, [...options, "--edit", edit]));

  await editor.page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), before.mesh);
  assert.equal(difference(before.view, await editor.view()), 0, "undo left the picture changed");
  await editor.page.click("#toolbar [data-action='redo']");
  assert.deepEqual(await editor.meshJson("mm"), after.mesh);
});

test("a press of any Undo or Redo button changes one edit", async ({ editor, page }) => {
  for (const mm of [1, 2, 3, 4]) await editor.setSlider("nose-width", mm);
  await editor.unfold("section-history");
  for (const [place, action, left] of [["#toolbar", "undo", 3], ["#section-history", "undo", 2], ["#section-history", "redo", 3], ["#toolbar", "redo", 4]]) {
    await page.click(`${place} [data-action='${action}']`);
    assert.equal((await editor.history()).length, left, `${action} in ${place}`);
  }
});

test("rotating details follow each tick and give the command line's mesh", { tag: ["@eyes", "@rare"] }, async ({ editor }) => {
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

test("light, display and camera change the picture, and the view resets", { tag: ["@eyes", "@rare"] }, async ({ editor }) => {
  await editor.unfold("light");
  await editor.page.check("#light-photo");
  const first = await editor.view();
  await editor.page.locator("#light-lamp .number-field").first().fill("80");
  const lit = await editor.view();
  assert.ok(difference(first, lit) > 0.02, "the light had no effect");
  await editor.page.check("input[name='shading'][value='colours']", { force: true });
  const painted = await editor.view();
  assert.ok(difference(lit, painted) > 0.02, "the display had no effect");
  // Starts outside the face, where no point can be dragged.
  await editor.drag(await editor.emptyPoint(), { x: 120, y: 20 });
  assert.ok(difference(painted, await editor.view()) > 0.05, "the drag did not turn the face");
  await editor.page.click("[data-action='reset-view']");
  assert.ok(difference(painted, await editor.view()) < 0.001, "the view was not reset");
});
