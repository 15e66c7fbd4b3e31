import assert from "node:assert/strict";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { LANDMARKS, assertSameMesh, maxDisplacement, displacement } from "./meshes.mjs";
import { colourCount, difference, differenceNear } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

const NOSE_TIP = 1;
/** Right and left corner of the mouth. */
const MOUTH_CORNERS = [61, 291];

test("hovering a landmark highlights and names it, and leaving it clears both", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  const beside = await editor.emptyPoint();
  await page.mouse.click(beside.x, beside.y);
  assert.ok(await page.isHidden("#landmark-tag"));
  assert.ok(await page.evaluate(() => document.activeElement?.matches("#viewport:not(:focus-visible)")));
  const plain = await editor.view();
  await page.mouse.move(tip.x, tip.y);
  await editor.frames(2);
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1");
  assert.equal(await editor.cursor(), "move");
  assert.ok(difference(plain, await editor.view()) > 0, "the landmark is not highlighted");
  await page.mouse.move(beside.x, beside.y);
  await editor.frames(2);
  assert.ok(await page.isHidden("#landmark-tag"));
  assert.equal(await editor.cursor(), "grab");
});

test("a landmark follows the pointer in the view plane, more slowly with Shift, and shows its influence", { tag: ["@eyes", "@usual"] }, async ({ editor, page }) => {
  // With it, the tip stays in the plane of symmetry, which the photo does not show edge-on.
  await editor.reveal("#edit-mirror");
  await page.uncheck("#edit-mirror");
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  const start = await editor.meshJson("mm");
  await editor.grab(tip, { x: 0, y: -40 });
  const moving = await editor.view();
  assert.ok(colourCount(moving) > 40);
  const seen = await editor.tagPosition();
  assert.ok(Math.hypot(seen.x - tip.x, seen.y - tip.y + 40) <= 1.5, `it is at ${seen.x}, ${seen.y}`);
  await page.mouse.up();
  const around = await editor.toViewPixels({ x: tip.x, y: tip.y - 40 });
  assert.ok(differenceNear(moving, await editor.view(), around, 30) > 0.3, "the influence is not displayed");
  const moved = await editor.meshJson("mm");
  const usual = displacement(start, moved, NOSE_TIP);
  assert.ok(usual[1] > 2 && Math.abs(usual[2]) < usual[1] / 2, `${usual}`);
  assert.ok(maxDisplacement(start, moved) < 1.5 * Math.hypot(...usual), `a vertex went ${maxDisplacement(start, moved)} mm`);
  assert.deepEqual(await editor.history(), ["nose tip · 1"]);

  await page.keyboard.down("Shift");
  await editor.drag({ x: tip.x, y: tip.y - 40 }, { x: 0, y: -40 });
  await page.keyboard.up("Shift");
  const fine = displacement(moved, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(Math.abs(fine[1] / usual[1] - 0.1) < 0.02, `${fine[1]} mm, not a tenth of ${usual[1]}`);
  for (let undo = 0; undo < 2; undo++) await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), start);
});

test("X, Y and Z restrict a drag to an axis, and Escape cancels it", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.reveal("#edit-mirror");
  await page.uncheck("#edit-mirror");
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  const start = await editor.meshJson("mm");
  for (const [axis, key] of ["x", "y", "z"].entries()) {
    await editor.grab(tip, { x: 10, y: -10 });
    await page.keyboard.press(key);
    await page.mouse.move(tip.x + 20, tip.y - 30, { steps: 3 });
    await page.mouse.up();
    const along = displacement(start, await editor.meshJson("mm"), NOSE_TIP);
    const others = along.filter((_, other) => other !== axis);
    // From the front, the z axis points at the viewer: moving up means nearer.
    assert.ok(along[axis] > 0.5 && Math.hypot(...others) < 1e-9, `${key}: ${along}`);
    await page.click("#toolbar [data-action='undo']");
  }

  await editor.grab(tip, { x: 30, y: 0 });
  await page.keyboard.press("Escape");
  const rest = await editor.view();
  await page.mouse.move(tip.x + 80, tip.y + 40, { steps: 3 });
  assert.equal(difference(rest, await editor.view()), 0, "the cancelled drag still had an effect");
  await page.mouse.up();
  assert.deepEqual(await editor.meshJson("mm"), start);
  assert.deepEqual(await editor.history(), []);
  assert.match(await page.inputValue("#landmark-search"), /nose tip/);

  await page.focus("#viewport");
  await page.keyboard.press("Escape");
  // The tag also names the point under the pointer.
  await page.mouse.move(1, 1);
  assert.ok(await page.isHidden("#landmark-tag"), "Escape did not clear the selection");
});

test("the wheel changes the influence radius during a drag, which stays one edit", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  const tip = await editor.tagPosition();
  const start = await editor.meshJson("mm");
  await editor.grab(tip, { x: 0, y: -30 });
  const radius = page.locator("#edit-radius .number-field");
  const pictures = [await editor.view()];
  const radii_mm = [];
  for (const wheel of [-400, -400, 300]) {
    await page.mouse.wheel(0, wheel);
    await editor.frames(3);
    assert.ok(await page.isChecked("#edit-nearby"));
    radii_mm.push(Number(await radius.inputValue()));
    assert.equal(await page.innerText("#landmark-tag"), `nose tip · 1, within ${radii_mm.at(-1)} mm`);
    pictures.push(await editor.view());
  }
  await page.mouse.up();
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1");
  assert.ok(radii_mm[1] < radii_mm[0] && radii_mm[0] < 25 && radii_mm[2] > radii_mm[1], `${radii_mm}`);
  for (const [shot, picture] of pictures.slice(1).entries()) assert.ok(difference(pictures[shot], picture) > 0);
  assert.equal((await editor.history()).length, 1);
  const after = await editor.meshJson("mm");
  assert.ok(displacement(start, after, NOSE_TIP)[1] > 1);
  // Geodesic distances are at least as long as straight ones, so these vertices are outside the influence radius.
  for (const [vertex, place] of start.positions.slice(0, LANDMARKS).entries()) {
    const apart_mm = Math.hypot(...place.map((at, axis) => at - start.positions[NOSE_TIP][axis]));
    const moved_mm = Math.hypot(...displacement(start, after, vertex));
    if (apart_mm > radii_mm[2]) assert.ok(moved_mm < 1e-6, `vertex ${vertex}, ${apart_mm} mm away, moved by ${moved_mm} mm`);
  }
});

test("Alt and a click pin a landmark, which then stays in place, and unpin it", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.findLandmark(String(MOUTH_CORNERS[0]));
  const corner = await editor.tagPosition();
  await editor.findLandmark("nose tip");
  const unpinned = await editor.view();
  const count = async () => Number.parseInt(await page.textContent("#landmark-anchors"), 10);
  const before = await count();
  await page.keyboard.down("Alt");
  await page.mouse.click(corner.x, corner.y);
  assert.equal(await editor.selectedLandmark(), NOSE_TIP);
  assert.ok((await count()) > before, "no point was pinned");
  assert.ok(difference(unpinned, await editor.view()) > 0, "no pin is drawn");
  const start = await editor.meshJson("mm");
  await editor.setOffset("y", -5);
  assert.ok(Math.hypot(...displacement(start, await editor.meshJson("mm"), MOUTH_CORNERS[0])) < 1e-9);
  await page.mouse.click(corner.x, corner.y);
  await page.keyboard.up("Alt");
  assert.equal(await count(), before);
});

test("each operator and constraint has a description and gives the command line's result", async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  const helps = new Set();
  const operators = await page.locator("#operator option").evaluateAll((options) => options.map((option) => option.value));
  assert.ok(operators.length >= 6 && operators.includes("cotangent-mass"), operators.join(" "));
  for (const operator of operators) {
    await editor.reveal("#operator");
    await page.selectOption("#operator", operator);
    helps.add(await page.innerText("#operator-help"));
    const [hold, weight] = operator === "degree" ? ["soft", "1"] : ["exact", "exact"];
    await page.selectOption("#constraint", hold);
    helps.add(await page.innerText("#constraint-help"));
    await editor.setOffset("z", 6);
    const options = `--units mm --topology canonical --operator ${operator} --constraint ${weight} --anchors oval --radius 25 --mirror --edit 1:0,0,6`;
    assertSameMesh(await editor.meshJson("mm"), await meshByCommandLine(SAMPLE, options.split(" ")));
    await page.click("#toolbar [data-action='undo']");
  }
  assert.equal(helps.size, operators.length + 2);
  assert.ok(!helps.has(""));
  assert.ok(!(await page.isChecked("input[name='preset'][value='paper']")));
  await editor.choosePreset("sculpt");
  assert.equal(await page.inputValue("#operator"), "cotangent");
});
