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
  await page.waitForFunction(() => /anywhere/.test(document.getElementById("selection-help").textContent));
  // The denser mesh follows after its message is painted.
  await visitor.frames(3);
}

/** Finds a point by name or number, without choosing landmarks. @param {import("./visitor.mjs").Visitor} visitor @param {string} text */
async function findPoint({ page }, text) {
  await page.fill("#landmark-search", text);
  await page.press("#landmark-search", "Enter");
}

test("a point of the densest mesh can be clicked, dragged and undone, with the command line's result", { tag: "@eyes" }, async ({ editor, page }) => {
  await choosePoints(editor, 3);
  assert.equal(await page.inputValue("#density"), "3");
  await findPoint(editor, "nose tip");
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

test("edits of points reopen from a GLB", async ({ editor, open }) => {
  await choosePoints(editor, 2);
  await findPoint(editor, "5000");
  await editor.setOffset("z", 2);
  const moved = await editor.meshJson("mm");
  const history = await editor.history();
  const glb = await editor.download("download-glb");

  const next = await open();
  await next.drop(glb, "face.glb");
  await next.untilFace();
  await next.page.waitForSelector("#history .check", { state: "attached" });
  assert.deepEqual(await next.history(), history);
  assert.ok(maxDisplacement(moved, await next.meshJson("mm")) < 1e-4);
});
