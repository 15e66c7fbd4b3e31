import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { displacement } from "./meshes.mjs";
import { accentPixels } from "./pixels.mjs";

test.use({ visit: { expert: true } });

const NOSE_TIP = 1;
const FOREHEAD = 151;
const NOSE_SIDES = [45, 275];
/** Centres of the upper and lower eyelids, and inner contour of the lips. */
const EYELIDS = [159, 386, 145, 374];
const INNER_LIPS = [13, 14, 82, 87, 312, 317];

test("the nose can move sideways without mirroring, up to the slider's limit", async ({ editor, page }) => {
  assert.ok(await page.isChecked("#edit-mirror"));
  const tip = await editor.landmarkPosition(NOSE_TIP);
  const start = await editor.meshJson("mm");
  await editor.grab(tip, { x: 40, y: 0 });
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1, not mirrored");
  await page.mouse.up();
  const [dx, dy, dz] = displacement(start, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(dx > 5 && Math.hypot(dy, dz) < 0.2 * dx, `it went by ${dx}, ${dy}, ${dz}`);
  assert.deepEqual(await editor.history(), ["nose tip · 1"]);
  await page.click("#toolbar [data-action='undo']");
  await editor.drag(tip, { x: 3, y: -40 });
  const moved = await editor.meshJson("mm");
  assert.ok(Math.abs(displacement(start, moved, NOSE_TIP)[0]) < 1e-9, "a nearly vertical drag moved the nose sideways");
  const [right, left] = NOSE_SIDES.map((wing) => displacement(start, moved, wing));
  assert.ok(right[1] > 0.1 && Math.abs(right[0] + left[0]) < 1e-9 && Math.abs(right[1] - left[1]) < 1e-9);
  await page.click("#toolbar [data-action='undo']");
  await editor.drag(tip, { x: 0, y: 0 });
  assert.deepEqual(await editor.history(), [], "a drag without motion made an edit");

  await editor.grab(tip, { x: 0, y: -600 });
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1, at its limit");
  assert.match(await page.innerText("#announcement"), /at its limit/);
  await page.mouse.up();
  const slider = page.locator("#landmark-offset [data-axis='y'] input[type=range]");
  assert.equal(await slider.inputValue(), await slider.getAttribute("max"));
  assert.ok(Math.abs(displacement(start, await editor.meshJson("mm"), NOSE_TIP)[1] - Number(await slider.inputValue())) < 1e-9);
  await page.click("#toolbar [data-action='undo']");

  await editor.drag(tip, { x: 37, y: 0 });
  const aside = await editor.meshJson("mm");
  await editor.setOffset("y", 5);
  const lifted = displacement(aside, await editor.meshJson("mm"), NOSE_TIP);
  assert.ok(lifted[1] > 3 && Math.hypot(lifted[0], lifted[2]) < 1e-9, `rounding by a slider moved the nose: ${lifted}`);
});

test("an edit shows its limited influence: pulling the nose leaves lips and eyelids in place", { tag: ["@eyes", "@rare"] }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  assert.ok(await page.isChecked("#edit-nearby") && (await page.isChecked("input[name='preset'][value='sculpt']")));
  const start = await editor.meshJson("mm");
  await editor.setOffset("z", 12);
  const moved = await editor.meshJson("mm");
  assert.ok(Math.abs(displacement(start, moved, NOSE_TIP)[2] - 12) < 1e-9);
  for (const vertex of [...EYELIDS, ...INNER_LIPS]) {
    const way_mm = Math.hypot(...displacement(start, moved, vertex));
    assert.ok(way_mm < 0.05, `${vertex} moved along by ${way_mm} mm`);
  }
  await page.click("#toolbar [data-action='undo']");

  const tip = await editor.landmarkPosition(NOSE_TIP);
  const shots = [];
  for (const nearby of [true, false]) {
    await editor.reveal("#edit-nearby");
    await page.setChecked("#edit-nearby", nearby);
    // Too small for the edit to be visible, but not for its influence.
    await editor.grab(tip, { x: 0, y: -8 });
    shots.push(await editor.view());
    await page.keyboard.press("Escape");
    await page.mouse.up();
  }
  const [near, whole] = shots;
  assert.ok(accentPixels(near) > accentPixels(whole) + 60, `${accentPixels(near)} and ${accentPixels(whole)} pixels of the accent`);
});

// The session's tests have the same for each mode.
for (const mode of ["landmark", "region", "point"]) {
  test(`a press grabs the highlighted point: ${mode}`, { tag: "@rare" }, async ({ editor }) => {
    await editor.reveal("#selection");
    await editor.page.check(`input[name='selection'][value='${mode}']`, { force: true });
    const { highlighted, mismatches } = await editor.dragAtEach(9);
    assert.ok(highlighted >= 12, `${highlighted} points are highlighted`);
    assert.deepEqual(mismatches, [], "highlighted points that a press does not grab");
  });
}

test("a press grabs the point highlighted under a resting pointer after the face has moved", { tag: "@rare" }, async ({ editor, page }) => {
  const tip = await editor.landmarkPosition(NOSE_TIP);
  const [x, y] = [tip.x + 45, tip.y - 30];
  await page.focus("#viewport");
  await page.mouse.move(x, y);
  const names = new Set([await page.textContent("#landmark-tag")]);
  for (const key of ["ArrowLeft", "ArrowLeft", "ArrowUp", "l", "t"]) {
    await page.keyboard.press(key);
    await editor.frames(4);
    const name = await page.textContent("#landmark-tag");
    const isLit = (await editor.cursor()) === "move";
    names.add(isLit ? name : "nothing");
    await page.mouse.down();
    await page.mouse.move(x + 9, y + 9, { steps: 3 });
    await page.mouse.up();
    const [entry] = await editor.history();
    assert.equal(entry, isLit ? name : undefined, key);
    await page.keyboard.press("Control+z");
    if (!isLit) await page.keyboard.press(" ");
    await page.mouse.move(x, y);
  }
  assert.ok(names.size > 3, `the same everywhere: ${[...names]}`);
});

test("dragging outside the face, or with another button, turns it, and pans with Shift", { tag: "@rare" }, async ({ editor, page }) => {
  const tip = await editor.landmarkPosition(NOSE_TIP);
  const brow = await editor.landmarkPosition(FOREHEAD);
  const beside = await editor.emptyPoint();
  /** Motion of nose and forehead caused by a stroke. */
  const stroke = async (from, button) => {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down({ button });
    await page.mouse.move(from.x + 60, from.y, { steps: 5 });
    await page.mouse.up({ button });
    await page.keyboard.up("Shift");
    const [nose, forehead] = [await editor.landmarkPosition(NOSE_TIP), await editor.landmarkPosition(FOREHEAD)];
    await page.click("#toolbar [data-action='reset-view']");
    await editor.frames(3);
    return [nose.x - tip.x, forehead.x - brow.x];
  };
  for (const [from, button] of [[beside, "left"], [tip, "right"], [tip, "middle"]]) {
    const [nose, forehead] = await stroke(from, button);
    assert.ok(nose > forehead + 4, `${button}: the nose went by ${nose} px, the forehead by ${forehead}`);
    await page.keyboard.down("Shift");
    for (const went of await stroke(from, button)) assert.ok(Math.abs(went - 60) < 8, `${button} with Shift: ${went} px`);
  }
  assert.deepEqual(await editor.history(), []);
});
