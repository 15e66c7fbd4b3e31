import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference, differenceNear } from "./pixels.mjs";

const LENSES = ["portrait", "parallel", "near", "as-taken"];

/** @param {import("./visitor.mjs").Visitor} visitor @param {string} lens */
async function chooseLens(visitor, lens) {
  await visitor.unfold("section-view");
  await visitor.page.check(`input[name="lens"][value="${lens}"]`, { force: true });
  await visitor.frames(3);
}

/** @param {import("@playwright/test").Page} page */
async function turnLeft(page) {
  await page.focus("#viewport");
  await page.keyboard.press("l");
}

test("each lens changes the view and the saved picture, and has a description", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  assert.ok(await page.isChecked("input[name='lens'][value='portrait']"));
  const home = await editor.view();
  // Only a turned view shows the chosen lens; the others show the photo's.
  await turnLeft(page);
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
  await turnLeft(page);
  assert.equal(difference(views[0], await editor.view()), 0, "the portrait was not restored");
  await page.click("#toolbar [data-action='reset-view']");
  assert.equal(difference(home, await editor.view()), 0, "the view was not reset");
  assert.deepEqual(await editor.history(), []);
});
