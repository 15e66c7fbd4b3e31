import assert from "node:assert/strict";
import { partsOfGlb, viewOf, withView } from "./changed-files.mjs";
import { glbByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { DENSEST, maxDisplacement } from "./meshes.mjs";
import { meanStep } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

test("a GLB of the command line's finest mesh opens with a pending edit and can be edited", async ({ visitor, page }) => {
  const options = "--units mm --topology canonical --density 4 --edit 20000@4:0,0,2 --edit 1:0,0,6".split(" ");
  const glb = await glbByCommandLine(SAMPLE, options);
  await visitor.drop(glb, "dense.glb");
  await visitor.untilFace();
  await page.waitForSelector("#history .check-notes > :nth-child(2)", { state: "attached" });
  assert.ok(await page.isHidden("#notice"));
  assert.equal(await page.inputValue("#density"), "3");
  const found = await visitor.meshJson("mm");
  assert.equal(found.positions.length, DENSEST);
  await visitor.unfold("section-history");
  const history = await visitor.history();
  assert.equal(history.length, 2);
  assert.match(history[1], /^point 20000/);

  await visitor.move("bottom of the chin", "y", -6);
  const work = await visitor.meshJson("mm");
  assert.ok(maxDisplacement(found, work) > 3);
  assert.equal((await visitor.history()).length, 3);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), found);
  await page.click("#toolbar [data-action='redo']");
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.meshJson("mm"), work);
  assert.equal((await visitor.history()).length, 3);
  assert.equal(await page.locator("#history .check-notes > :nth-child(2)").count(), 1);
});

test("a GLB whose shape was changed elsewhere opens as saved, with a notice; a halved texture is accepted", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.move("nose tip", "z", 6);
  const { positions } = await editor.meshJson("mm");
  const glb = await editor.download("download-glb");
  await clearSelection(editor);
  const view = await editor.view();
  const parts = partsOfGlb(glb);
  const shape = parts.json.accessors[parts.json.meshes[0].primitives[0].attributes.POSITION].bufferView;
  const wider = Buffer.from(viewOf(parts, shape));
  for (let place = 0; place < wider.length; place += 12) wider.writeFloatLE(1.3 * wider.readFloatLE(place), place);

  await editor.drop(withView(parts, shape, wider), "wider.glb");
  await page.waitForSelector("#notice[data-code='changed-elsewhere']");
  assert.match((await editor.notice()).text, /Another program changed this file\s+It opens as it was saved here/);
  assert.deepEqual((await editor.meshJson("mm")).positions, positions);
  await editor.drop(glb, "as-saved.glb");
  await page.waitForSelector("#notice", { state: "hidden" });
  await editor.untilFace();
  assert.ok(await page.isHidden("#notice"));

  const picture = parts.json.images[0].bufferView;
  const halved = withView(parts, picture, await halfAsLarge(page, viewOf(parts, picture)));
  await page.reload();
  await editor.drop(halved, "halved.glb");
  await editor.untilFace();
  assert.deepEqual((await editor.meshJson("mm")).positions, positions);
  await clearSelection(editor);
  const opened = await editor.view();
  for (const left of [0.42, 0.48, 0.54]) {
    for (const top of [0.32, 0.42, 0.54]) {
      const off = meanStep(view, opened, { left, top, right: left + 0.06, bottom: top + 0.08 });
      assert.ok(off < 8, `colours are ${off} levels off at ${left}, ${top}`);
    }
  }
});

/** Clears the selection and moves the pointer away, so that the view shows no marks. */
async function clearSelection(editor) {
  const { x, y } = await editor.emptyPoint();
  await editor.page.mouse.click(x, y);
  await editor.page.mouse.move(4, 4);
}

/** Halves a picture's width and height, as JPEG. */
async function halfAsLarge(page, bytes) {
  const jpeg = await page.evaluate(async (bytes) => {
    const picture = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(picture.width / 2, picture.height / 2);
    canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
    const blob = await canvas.convertToBlob({ type: "image/jpeg", quality: 0.9 });
    return new Uint8Array(await blob.arrayBuffer());
  }, new Uint8Array(bytes));
  return Buffer.from(jpeg);
}
