import assert from "node:assert/strict";
import { variants, test } from "./fixtures.mjs";
import { assertRestored } from "./meshes.mjs";
import { colourCount, meanStep } from "./pixels.mjs";

test.use({ visit: { expert: true } });

for (const [paint, tag] of variants(["photo", "colours"])) {
  test(`a GLB with base colour ${paint} restores face and history after a reload`, { tag: [...tag, "@eyes"] }, async ({ editor, page }) => {
    const unedited = await editor.meshJson("mm");
    await editor.move("nose tip", "z", 9);
    await editor.move("bottom of the chin", "y", -6);
    const work = await editor.meshJson("mm");
    await editor.reveal("#export-units");
    await page.check(`input[name="base-colour"][value="${paint}"]`, { force: true });
    const file = await editor.download("download-glb");
    // A click outside the face clears the selection and its marks.
    await page.mouse.click(20, 20);
    const view = await editor.view();

    await page.reload();
    await editor.drop(file, "rosto.glb");
    await editor.untilFace();
    assertRestored(await editor.meshJson("mm"), work);
    assert.equal(await page.locator("#history .check").count(), 2);
    const opened = await editor.view();
    assert.ok(colourCount(opened) > 40, "the face was restored without its colours");
    // The texture is a JPEG, so compare means, not pixels.
    for (const left of paint === "photo" ? [0.4, 0.45, 0.5, 0.55] : []) {
      const step = meanStep(view, opened, { left, top: 0.45, right: left + 0.05, bottom: 0.55 });
      assert.ok(step < 3, `colours are ${step} levels off at ${left} of the width`);
    }

    for (const [action, mesh] of /** @type {const} */ ([["undo", unedited], ["redo", work]])) {
      for (let step = 0; step < 2; step++) await page.click(`#toolbar [data-action='${action}']`);
      assertRestored(await editor.meshJson("mm"), mesh);
    }
  });
}

test("a GLB restores the density and the eye and mouth openings", async ({ editor, page }) => {
  await editor.unfold("section-view");
  await page.selectOption("#triangulation", "tessellation");
  await page.selectOption("#density", "1");
  await editor.move("nose tip", "z", 4);
  const work = await editor.meshJson("mm");
  const file = await editor.download("download-glb");
  await page.reload();
  await editor.drop(file, "rosto.glb");
  await editor.untilFace();
  const opened = await editor.meshJson("mm");
  assert.deepEqual(opened.positions, work.positions);
  assert.deepEqual(opened.triangles, work.triangles);
});
