import assert from "node:assert/strict";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh, displacement } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

/** The page's default edit options, as options of the command line. */
const PAGE_OPTIONS = "--units mm --topology canonical --operator cotangent --constraint exact --anchors oval --radius 25 --mirror".split(" ");

const NOSE_TIP = 1;
const CHIN = 152;

test("a region moves as one by its sliders, with its name, like on the command line", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.selectRegion("left-brow");
  assert.match(await page.innerText("#announcement"), /left brow selected/);
  assert.equal(await page.innerText("#landmark-tag"), "left brow");
  const before = { view: await editor.view(), mesh: await editor.meshJson("mm") };
  await editor.setOffset("y", 3);
  await editor.setOffset("z", -1);
  assert.ok(difference(before.view, await editor.view()) > 0.002, "the picture did not change");
  assert.deepEqual(await editor.history(), ["left brow", "left brow"]);
  const steps = ["--region", "left-brow:0,3,0", "--region", "left-brow:0,0,-1"];
  assertSameMesh(await editor.meshJson("mm"), await meshByCommandLine(SAMPLE, [...PAGE_OPTIONS, ...steps]));

  await page.selectOption("#language", "pt");
  assert.deepEqual(await editor.history(), ["sobrancelha esquerda", "sobrancelha esquerda"]);
  assert.equal(await page.locator("#region option:checked").innerText(), "sobrancelha esquerda");
});

test("a region can be dragged by each of its landmarks and by its gizmo", { tag: "@eyes" }, async ({ editor }) => {
  await editor.findLandmark("nose tip");
  const noseTip = await editor.tagPosition();
  await editor.selectRegion("nose");
  const start = await editor.meshJson("mm");

  await editor.drag(noseTip, { x: 0, y: -24 });
  assert.deepEqual(await editor.history(), ["nose"]);
  const lifted = await editor.meshJson("mm");
  const [tip, wing, chin] = [NOSE_TIP, 64, CHIN].map((landmark) => displacement(start, lifted, landmark));
  assert.ok(tip[1] > 1 && Math.abs(tip[1] - wing[1]) < 1e-9, `${tip} and ${wing}`);
  assert.ok(Math.hypot(...chin) < tip[1] / 2, `the chin moved along: ${chin}`);

  const middle = await editor.selectionPosition();
  await editor.drag({ x: middle.x, y: middle.y - 50 }, { x: 30, y: 20 });
  assert.deepEqual(await editor.history(), ["nose", "nose"]);
  const along = displacement(lifted, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(along[1] < -1 && Math.hypot(along[0], along[2]) < 1e-9, `not along y: ${along}`);
});

test("clicks select the region under the pointer, then a larger one, and landmark mode restores the landmark", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  const beside = await editor.emptyPoint();
  await page.mouse.click(beside.x, beside.y);
  await editor.reveal("#selection");
  await page.check("input[name='selection'][value='region']", { force: true });
  assert.ok(await page.isHidden("#landmark-search"));
  const plain = await editor.view();
  await page.mouse.move(tip.x, tip.y);
  const pointedAt = await editor.view();
  assert.ok(difference(plain, pointedAt) > 0.001, "the region under the pointer is not marked");
  assert.equal(await page.innerText("#landmark-tag"), "tip of the nose");
  await page.mouse.move(beside.x, beside.y);
  assert.equal(difference(plain, await editor.view()), 0, "the marks stay");
  const taken = [];
  for (let click = 0; click < 3; click++) {
    await page.mouse.click(tip.x, tip.y);
    taken.push(await page.inputValue("#region"));
  }
  assert.deepEqual(taken, ["nose-tip", "nose", "nose-tip"]);
  await page.check("input[name='selection'][value='landmark']", { force: true });
  assert.ok(await page.isHidden("#region"));
  assert.match(await page.inputValue("#landmark-search"), /nose tip$/);
});
