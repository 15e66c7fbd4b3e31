import assert from "node:assert/strict";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { assertPortraitColours } from "./portrait-colours.mjs";
import { SAMPLE } from "./visitor.mjs";

test("a dropped portrait becomes a mesh in its own colours", { tag: "@eyes" }, async ({ visitor }) => {
  await visitor.dropSample();
  await assertPortraitColours(await visitor.view());
});

test("moving the nose tip changes picture and mesh as the command line does, and undo restores both", { tag: "@eyes" }, async ({ visitor }) => {
  await visitor.openFace();
  await visitor.prefer("paper");
  await visitor.unfold("section-view");
  await visitor.page.click("[data-action='view-left']");
  await visitor.findLandmark("nose tip");
  const before = { view: await visitor.view(), mesh: await visitor.meshJson("mm") };
  await visitor.offset("z", 12);
  const anchors = await visitor.anchors();
  assert.equal(anchors.length, 2);
  const after = { view: await visitor.view(), mesh: await visitor.meshJson("mm") };
  assert.ok(difference(before.view, after.view) > 0.002, "the picture did not change");

  const edit = `${await visitor.landmark()}:0,0,12:${anchors.join(",")}`;
  const options = ["--units", "mm", "--density", "0"];
  assertSameMesh(before.mesh, await meshByCommandLine(SAMPLE, options));
  assertSameMesh(after.mesh, await meshByCommandLine(SAMPLE, [...options, "--edit", edit]));

  await visitor.page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), before.mesh);
  assert.equal(difference(before.view, await visitor.view()), 0, "undo left the picture changed");
  await visitor.page.click("#toolbar [data-action='redo']");
  assert.deepEqual(await visitor.meshJson("mm"), after.mesh);
});

test("details that turn with the surface follow every tick, and make the command line's mesh", { tag: ["@eyes", "@rare"] }, async ({ visitor }) => {
  await visitor.openFace();
  await visitor.findLandmark("61");
  await visitor.unfold("section-advanced");
  await visitor.page.selectOption("#details", "turned");
  const before = await visitor.view();
  await visitor.page.fill("#landmark-sliders [data-axis='z'] input[type=number]", "14");
  const moving = await visitor.view();
  assert.ok(difference(before, moving) > 0.002, "the picture did not change while the number was typed");
  await visitor.page.press("#landmark-sliders [data-axis='z'] input[type=number]", "Tab");
  const options = "--units mm --topology canonical --operator cotangent --hold exact --anchors oval --radius 25 --mirror --turn-details";
  const turned = await meshByCommandLine(SAMPLE, [...options.split(" "), "--edit", "61:0,0,14"]);
  assertSameMesh(await visitor.meshJson("mm"), turned);
  const kept = await meshByCommandLine(SAMPLE, [...options.split(" ").slice(0, -1), "--edit", "61:0,0,14"]);
  assert.throws(() => assertSameMesh(kept, turned), "details that keep their direction make the same mesh");
});

test("a point is picked by clicking it on the mesh", async ({ visitor }) => {
  await visitor.openFace();
  const box = await visitor.page.locator("#viewport").boundingBox();
  await visitor.page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.match(await visitor.page.inputValue("#landmark-search"), / · \d+$/);
  assert.ok(await visitor.page.locator("#landmark-tag").isVisible());
});

test("light, paint and camera change the picture, and the view resets", { tag: "@eyes" }, async ({ visitor }) => {
  await visitor.openFace();
  await visitor.unfold("section-view");
  await visitor.page.check("#light-photo");
  const first = await visitor.view();
  await visitor.page.locator("#light-sliders input[type=number]").first().fill("80");
  const lit = await visitor.view();
  assert.ok(difference(first, lit) > 0.02, "the light moved without effect");
  await visitor.page.check("input[name='shading'][value='colours']", { force: true });
  const painted = await visitor.view();
  assert.ok(difference(lit, painted) > 0.02, "the paint changed without effect");
  const box = await visitor.page.locator("#viewport").boundingBox();
  // Beside the face: on it, a drag may move a landmark.
  const [x, y] = [box.x + 40, box.y + box.height / 2];
  await visitor.page.mouse.move(x, y);
  await visitor.page.mouse.down();
  await visitor.page.mouse.move(x + 120, y + 20, { steps: 4 });
  await visitor.page.mouse.up();
  await visitor.page.mouse.move(box.x + 4, box.y + 4);
  assert.ok(difference(painted, await visitor.view()) > 0.05, "the drag did not turn the face");
  await visitor.page.click("[data-action='reset-view']");
  await visitor.page.mouse.move(box.x + 4, box.y + 4);
  assert.ok(difference(painted, await visitor.view()) < 0.001, "the view did not come back");
});
