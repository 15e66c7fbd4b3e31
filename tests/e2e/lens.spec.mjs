import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference, differenceNear } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

const LENSES = ["portrait", "parallel", "near", "as-taken"];
/** Nose tip, chin, outer corners of the eyes, corners of the mouth. */
const ALL_OVER = [1, 152, 33, 263, 61, 291];

/** @param {import("./visitor.mjs").Visitor} visitor @param {string} lens */
async function chooseLens(visitor, lens) {
  await visitor.unfold("section-view");
  await visitor.page.check(`input[name="lens"][value="${lens}"]`, { force: true });
  await visitor.frames(3);
}

test("each lens changes the view and the saved picture, and has a description", { tag: ["@eyes", "@rare"] }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  assert.ok(await page.isChecked("input[name='lens'][value='portrait']"));
  const [views, pictures, helps] = [[], [], new Set()];
  for (const lens of LENSES) {
    await chooseLens(editor, lens);
    helps.add(await page.innerText("#lens-help"));
    views.push(await editor.view());
    pictures.push(PNG.sync.read(await editor.download("download-picture")));
  }
  assert.ok(helps.size === LENSES.length && !helps.has(""));
  const middle = { x: Math.round(views[0].width / 2), y: Math.round(views[0].height / 2) };
  for (const [other, another] of LENSES.entries()) {
    for (const [one, lens] of LENSES.slice(0, other).entries()) {
      assert.ok(differenceNear(views[one], views[other], middle, 200) > 0.02, `${lens} looks like ${another}`);
      assert.ok(difference(pictures[one], pictures[other]) > 0.01, `${lens} is saved like ${another}`);
    }
  }
  await chooseLens(editor, "portrait");
  await page.click("#toolbar [data-action='reset-view']");
  assert.equal(difference(views[0], await editor.view()), 0, "the portrait was not restored");
  assert.deepEqual(await editor.history(), []);
});

for (const lens of ["parallel", "near"]) {
  test(`with a lens, a press grabs the highlighted point: ${lens}`, { tag: "@rare" }, async ({ editor, page }) => {
    await chooseLens(editor, lens);
    // Turned, raised and nearer, so that the view's axes differ from the face's.
    await page.focus("#viewport");
    for (const key of ["ArrowLeft", "ArrowUp", "Alt+ArrowUp"]) await page.keyboard.press(key);
    await editor.frames(3);
    const { highlighted, mismatches } = await editor.dragAtEach(7);
    assert.ok(highlighted >= 7, `${highlighted} points are highlighted`);
    assert.deepEqual(mismatches, [], "highlighted points that a press does not grab");
  });
}

test("with the photo's lens, the mesh matches the photo, and the lens is saved", { tag: "@rare" }, async ({ editor, page }) => {
  await chooseLens(editor, "as-taken");
  const { width, height } = PNG.sync.read(await readFile(SAMPLE));
  const { positions } = await editor.meshJson("image");
  const pairs = [];
  for (const landmark of ALL_OVER) {
    const [x, y] = positions[landmark];
    pairs.push({ photo: { x: x * width, y: y * height }, seen: await editor.landmarkPosition(landmark) });
  }
  const [nose, chin] = pairs;
  const scale = (chin.seen.y - nose.seen.y) / (chin.photo.y - nose.photo.y);
  assert.ok(scale > 0.1, `${scale}`);
  for (const { photo, seen } of pairs) {
    const off = [seen.x - nose.seen.x - scale * (photo.x - nose.photo.x), seen.y - nose.seen.y - scale * (photo.y - nose.photo.y)];
    assert.ok(Math.hypot(...off) < 1.5, `${off} px off`);
  }
  await page.reload();
  await editor.resume();
  await editor.unfold("section-view");
  assert.ok(await page.isChecked("input[name='lens'][value='as-taken']"));
  const again = await editor.landmarkPosition(ALL_OVER[0]);
  assert.ok(Math.hypot(again.x - nose.seen.x, again.y - nose.seen.y) < 1.5, `the nose is at ${again.x}, ${again.y}`);
});
