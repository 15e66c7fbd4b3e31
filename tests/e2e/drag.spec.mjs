import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

test.use({ visit: { expert: true } });

const NOSE_TIP = 1;
const FOREHEAD = 151;

test("the tag says that a drag is not mirrored, or is at the slider's limit", async ({ editor, page }) => {
  const tip = await editor.landmarkPosition(NOSE_TIP);
  await editor.grab(tip, { x: 40, y: 0 });
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1, not mirrored");
  await page.mouse.up();
  await page.click("#toolbar [data-action='undo']");

  await editor.grab(tip, { x: 0, y: -600 });
  assert.equal(await page.innerText("#landmark-tag"), "nose tip · 1, at its limit");
  assert.match(await page.innerText("#announcement"), /at its limit/);
  await page.mouse.up();
  const slider = page.locator("#landmark-offset [data-axis='y'] input[type=range]");
  assert.equal(await slider.inputValue(), await slider.getAttribute("max"));
});

test("a press grabs the point highlighted under a resting pointer after the face has moved", async ({ editor, page }) => {
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

test("dragging outside the face, or with another button, turns it, and pans with Shift", async ({ editor, page }) => {
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
