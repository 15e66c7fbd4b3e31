import assert from "node:assert/strict";
import { PAGE_EDIT_OPTIONS, meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameShape, DENSEST, maxDisplacement, LANDMARKS, displacement } from "./meshes.mjs";
import { difference } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

/**
 * Selects by points of a mesh with the given density.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @param {number} density
 */
async function choosePoints(visitor, density) {
  const { page } = visitor;
  await visitor.unfold("section-landmark");
  await page.check("input[name='selection'][value='point']", { force: true });
  await page.selectOption("#point-density", String(density));
  await page.waitForFunction(() => /anywhere/.test(document.getElementById("landmark-help").textContent));
  // The denser mesh follows after its message is painted.
  await visitor.frames(3);
}

test("a point of the densest mesh can be clicked, dragged and undone, with the command line's result", { tag: ["@eyes", "@rare"] }, async ({ editor, page }) => {
  await choosePoints(editor, 3);
  assert.equal(await page.inputValue("#density"), "3");
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  // Removes the gizmo, which a click would hit.
  await page.focus("#viewport");
  await page.keyboard.press("Escape");
  // Next to the nose, away from landmarks.
  await page.mouse.click(tip.x + 31, tip.y + 7);
  await editor.frames(3);
  const vertex = await editor.selectedPoint();
  assert.ok(vertex >= LANDMARKS && vertex < DENSEST, `${vertex}`);
  assert.match(await page.innerText("#landmark-tag"), /^point \d+ near the .+$/);
  const at = await editor.tagPosition();
  const start = await editor.meshJson("mm");
  assert.equal(start.positions.length, DENSEST);
  const before = await editor.view();

  await editor.grab(at, { x: 10, y: -20 });
  const seen = await editor.tagPosition();
  assert.ok(Math.hypot(seen.x - at.x - 10, seen.y - at.y + 20) <= 1.5, `it is at ${seen.x}, ${seen.y}`);
  await page.mouse.up();
  const moved = await editor.meshJson("mm");
  assert.ok(difference(before, await editor.view()) > 0.002, "the picture did not change");
  const offset = displacement(start, moved, vertex);
  assert.ok(offset[0] > 0.5 && offset[1] > 1, `${offset}`);
  assert.ok(maxDisplacement(start, moved) < 1.2 * Math.hypot(...offset));
  const [entry] = await editor.history();
  assert.match(entry, new RegExp(`^point ${vertex} near the `));

  const edit = `${vertex}@3:${offset.join(",")}`;
  assertSameShape(moved, await meshByCommandLine(SAMPLE, [...PAGE_EDIT_OPTIONS, "--density", "3", "--edit", edit]));
  await page.selectOption("#language", "pt");
  assert.match((await editor.history())[0], new RegExp(`^ponto ${vertex} perto d[ao] `));
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), start);
});

test("a point moves by sliders on both sides, waits on a coarser mesh, and can be switched off", { tag: "@rare" }, async ({ editor, page }) => {
  await choosePoints(editor, 1);
  const start = await editor.meshJson("mm");
  await editor.findLandmark("1500");
  assert.equal(await editor.selectedPoint(), 1_500);
  await editor.setOffset("z", 3);
  const moved = await editor.meshJson("mm");
  assert.ok(Math.abs(displacement(start, moved, 1_500)[2] - 3) < 1e-9);
  const both = moved.positions.filter((_, vertex) => Math.abs(displacement(start, moved, vertex)[2] - 3) < 1e-9);
  assert.equal(both.length, 2, "the other side did not follow");

  await editor.reveal("#point-density");
  await page.selectOption("#point-density", "0");
  assert.deepEqual(await editor.history(), [`point 1500 near the ${(await editor.history())[0].split(" near the ")[1]}`]);
  assert.match(await page.innerText("#history .check-notes > :nth-child(2)"), /1,833 points/);
  assert.match(await page.inputValue("#landmark-search"), / · \d+$/);
  assert.equal((await editor.meshJson("mm")).positions.length, LANDMARKS);
  await editor.reveal("#point-density");
  await page.selectOption("#point-density", "1");
  await page.waitForSelector("#history .check-notes > :nth-child(2)", { state: "detached" });
  assert.deepEqual(await editor.meshJson("mm"), moved);

  await editor.unfold("section-history");
  await page.uncheck("#history input");
  assert.deepEqual(await editor.meshJson("mm"), start);
  await editor.reveal("#history");
  await page.check("#history input");
  assert.deepEqual(await editor.meshJson("mm"), moved);
});

test("edits of points reopen from a GLB, and keep their position when eyes and mouth are opened", { tag: "@rare" }, async ({ editor, page, open }) => {
  await choosePoints(editor, 2);
  const start = await editor.meshJson("mm");
  await editor.move("5000", "z", 2);
  const moved = await editor.meshJson("mm");
  const history = await editor.history();
  const glb = await editor.download("download-glb");

  const next = await open();
  await next.drop(glb, "face.glb");
  await next.untilFace();
  await next.page.waitForSelector("#history .check", { state: "attached" });
  assert.deepEqual(await next.history(), history);
  assert.ok(maxDisplacement(moved, await next.meshJson("mm")) < 1e-4);

  await page.selectOption("#triangulation", "tessellation", { force: true });
  await editor.frames(3);
  await editor.reveal("#edit-mirror");
  assert.ok(await page.isDisabled("#edit-mirror"));
  assert.ok(await page.isVisible("#edit-mirror-none"));
  const opened = await editor.meshJson("mm");
  const lifted = opened.positions.map((place) => Math.hypot(...place.map((at, axis) => at - moved.positions[5_000][axis])));
  assert.ok(Math.min(...lifted) < 1, "the point did not move along");
  assert.notEqual(opened.positions.length, start.positions.length);
});

test("on a dense mesh the error for an unknown point does not mention the range of landmarks", { tag: "@rare" }, async ({ editor, page }) => {
  await choosePoints(editor, 2);
  await editor.findLandmark("7000");
  assert.equal(await editor.selectedPoint(), 7_000);
  for (const language of ["en", "pt"]) {
    await page.selectOption("#language", language);
    await editor.findLandmark("999999");
    assert.match(await page.innerText("#landmark-search-error"), /999999/);
    assert.doesNotMatch(await page.innerText("#section-landmark"), /\b467\b/);
    assert.ok(await page.isHidden("#notice"));
  }
});
