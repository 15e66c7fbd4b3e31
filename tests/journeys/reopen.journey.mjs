import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { assertCameBack } from "./meshes.mjs";
import { colourCount, meanColour } from "./pixels.mjs";

for (const [paint, tag] of alike(["photo", "colours"])) {
  test(`a downloaded GLB painted with ${paint} brings the face back after a reload, with its history`, { tag: [...tag, "@eyes"] }, async ({ editor, page }) => {
    const unedited = await editor.meshJson("mm");
    await editor.move("nose tip", "z", 9);
    await editor.move("bottom of the chin", "y", -6);
    const work = await editor.meshJson("mm");
    await editor.reach("#export-units");
    await page.check(`input[name="base-colour"][value="${paint}"]`, { force: true });
    const file = await editor.download("download-glb");
    // Beside the face, a click lets go of the landmark and takes its marks away.
    await page.mouse.click(20, 20);
    const view = await editor.view();

    await page.reload();
    await editor.drop(file, "rosto.glb");
    await editor.untilFace();
    assertCameBack(await editor.meshJson("mm"), work);
    assert.equal(await page.locator("#history li").count(), 2);
    assert.ok(colourCount(await editor.view()) > 40, "the face came back without its colours");
    if (paint === "photo") expectSameColours(view, await editor.view());

    for (let step = 0; step < 2; step++) await page.click("#toolbar [data-action='undo']");
    assertCameBack(await editor.meshJson("mm"), unedited);
    await page.click("#toolbar [data-action='redo']");
    await page.click("#toolbar [data-action='redo']");
    assertCameBack(await editor.meshJson("mm"), work);
  });
}

test("a GLB brings its density and its eyes and mouth along", { tag: "@rare" }, async ({ editor, page }) => {
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

test("a GLB of another program, or half of ours, leaves the work and a message", async ({ editor, page }) => {
  await editor.move("nose tip", "z", 4);
  const work = await editor.meshJson("mm");
  const file = await editor.download("download-glb");
  for (const { bytes, code, says } of [
    { bytes: foreignGlb(), code: "foreign-glb", says: /no face that can be edited/ },
    { bytes: file.subarray(0, file.length / 2), code: "damaged-glb", says: /damaged or incomplete/ },
  ]) {
    await editor.drop(bytes, "other.glb");
    await page.waitForSelector(`#notice[data-code="${code}"]`);
    assert.match((await editor.notice()).text, says);
    assert.deepEqual(await editor.meshJson("mm"), work);
  }
});

/**
 * The texture is a JPEG, so that single pixels differ a little; on the mean of a patch it makes no difference.
 *
 * @param {import("./pixels.mjs").Pixels} before
 * @param {import("./pixels.mjs").Pixels} after
 */
function expectSameColours(before, after) {
  for (const left of [0.4, 0.45, 0.5, 0.55]) {
    const patch = { left, top: 0.45, right: left + 0.05, bottom: 0.55 };
    const [wanted, seen] = [meanColour(before, patch), meanColour(after, patch)];
    const furthest = Math.max(...wanted.map((level, channel) => Math.abs(level - seen[channel])));
    assert.ok(furthest < 3, `colours are ${furthest} levels off at ${left} of the width`);
  }
}

/** A GLB with nothing in it but its name. */
function foreignGlb() {
  const json = Buffer.from('{"asset":{"version":"2.0"},"scenes":[{}]} '.padEnd(44));
  const header = Buffer.alloc(20);
  header.write("glTF", 0);
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(20 + json.length, 8);
  header.writeUInt32LE(json.length, 12);
  header.write("JSON", 16);
  return Buffer.concat([header, json]);
}
