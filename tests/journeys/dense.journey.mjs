import assert from "node:assert/strict";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameShape, furthest, way } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

const DENSEST = 28_881;
const LANDMARKS = 468;

/** What the page does unless told otherwise, in the command line's words. */
const AS_THE_PAGE = "--units mm --topology canonical --operator cotangent --hold exact --anchors oval --radius 25 --mirror".split(" ");

/** A face at a density, with any of its points to be taken. */
async function arriveAtPoints(open, density) {
  const visitor = await open();
  await visitor.openFace();
  await visitor.unfold("section-landmark");
  await visitor.page.check("input[name='selection'][value='point']", { force: true });
  await visitor.page.selectOption("#point-density", String(density));
  await visitor.page.waitForFunction(() => /anywhere/.test(document.getElementById("landmark-help").textContent));
  return visitor;
}

/** A click beside the nose, where no landmark is. */
async function clickBesideTheNose(visitor) {
  await visitor.findLandmark("nose tip");
  const tip = await visitor.tagged();
  await visitor.page.mouse.click(tip.x + 31, tip.y + 7);
  await visitor.frames(3);
}

test("any point of the densest mesh is clicked, dragged and undone, as the command line moves it", { tag: ["@eyes", "@rare"] }, async ({ open }) => {
  const visitor = await arriveAtPoints(open, 3);
  const { page } = visitor;
  assert.equal(await page.inputValue("#density"), "3");
  await clickBesideTheNose(visitor);
  const vertex = await visitor.point();
  assert.ok(vertex >= LANDMARKS && vertex < DENSEST, `${vertex}`);
  assert.match(await page.innerText("#landmark-tag"), /^point [\d,]+ near the .+$/);
  const at = await visitor.tagged();
  const start = await visitor.meshJson("mm");
  assert.equal(start.positions.length, DENSEST);
  const before = await visitor.view();

  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 10, at.y - 20, { steps: 6 });
  const seen = await visitor.tagged();
  assert.ok(Math.hypot(seen.x - at.x - 10, seen.y - at.y + 20) <= 1.5, `it is at ${seen.x}, ${seen.y}`);
  await page.mouse.up();
  const moved = await visitor.meshJson("mm");
  assert.ok(difference(before, await visitor.view()) > 0.002, "the picture did not change");
  const offset = way(start, moved, vertex);
  assert.ok(offset[0] > 0.5 && offset[1] > 1, `${offset}`);
  assert.ok(furthest(start, moved) < 1.2 * Math.hypot(...offset));
  const [entry] = await visitor.history();
  assert.match(entry, new RegExp(`^point ${vertex.toLocaleString("en")} near the `));

  const edit = `${vertex}@3:${offset.join(",")}`;
  assertSameShape(moved, await meshByCommandLine(SAMPLE, [...AS_THE_PAGE, "--density", "3", "--edit", edit]));
  await page.selectOption("#language", "pt");
  assert.match((await visitor.history())[0], new RegExp(`^ponto ${vertex.toLocaleString("de")} perto d[ao] `));
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), start);
});

test("a point is moved by sliders on both sides, waits while the mesh is coarser, and can be switched off", { tag: "@rare" }, async ({ open }) => {
  const visitor = await arriveAtPoints(open, 1);
  const { page } = visitor;
  const start = await visitor.meshJson("mm");
  await visitor.findLandmark("1500");
  assert.equal(await visitor.point(), 1_500);
  await visitor.offset("z", 3);
  const moved = await visitor.meshJson("mm");
  assert.ok(Math.abs(way(start, moved, 1_500)[2] - 3) < 1e-9);
  const both = moved.positions.filter((_, vertex) => Math.abs(way(start, moved, vertex)[2] - 3) < 1e-9);
  assert.equal(both.length, 2, "the other side did not follow");

  await visitor.reach("#point-density");
  await page.selectOption("#point-density", "0");
  assert.deepEqual(await visitor.history(), [`point 1,500 near the ${(await visitor.history())[0].split(" near the ")[1]}`]);
  assert.match(await page.innerText("#history .waits"), /1,833 points/);
  assert.match(await page.inputValue("#landmark-search"), / · \d+$/);
  assert.equal((await visitor.meshJson("mm")).positions.length, LANDMARKS);
  await visitor.reach("#point-density");
  await page.selectOption("#point-density", "1");
  await page.waitForSelector("#history .waits", { state: "detached" });
  assert.deepEqual(await visitor.meshJson("mm"), moved);

  await visitor.unfold("section-history");
  await page.uncheck("#history input");
  assert.deepEqual(await visitor.meshJson("mm"), start);
  await visitor.reach("#history");
  await page.check("#history input");
  assert.deepEqual(await visitor.meshJson("mm"), moved);
});

test("edits of points come back from a GLB, and stay where they are when eyes and mouth are opened", { tag: "@rare" }, async ({ open }) => {
  const visitor = await arriveAtPoints(open, 2);
  const { page } = visitor;
  const start = await visitor.meshJson("mm");
  await visitor.move("5000", "z", 2);
  const moved = await visitor.meshJson("mm");
  const history = await visitor.history();
  const glb = await visitor.download("download-glb");

  const next = await open();
  await next.drop(glb, "face.glb");
  await next.untilFace();
  await next.page.waitForSelector("#history li", { state: "attached" });
  assert.deepEqual(await next.history(), history);
  assert.ok(furthest(moved, await next.meshJson("mm")) < 1e-4);

  await page.selectOption("#triangulation", "tessellation", { force: true });
  await visitor.frames(3);
  await visitor.reach("#mirror");
  assert.ok(await page.isDisabled("#mirror"));
  assert.ok(await page.isVisible("#mirror-help"));
  const opened = await visitor.meshJson("mm");
  const lifted = opened.positions.map((place) => Math.hypot(...place.map((at, axis) => at - moved.positions[5_000][axis])));
  assert.ok(Math.min(...lifted) < 1, "the point did not come along");
  assert.notEqual(opened.positions.length, start.positions.length);
});
