import assert from "node:assert/strict";
import { partsOfGlb, viewOf, withView } from "./changed-files.mjs";
import { glbByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { furthest } from "./meshes.mjs";
import { meanColour } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

const DENSEST = 28_881;

test("a GLB of the command line's finest mesh opens, with an edit that waits, and is gone on with", { tag: "@rare" }, async ({ open }) => {
  const options = "--units mm --topology canonical --density 4 --edit 20000@4:0,0,2 --edit 1:0,0,6".split(" ");
  const glb = await glbByCommandLine(SAMPLE, options);
  const visitor = await open();
  const { page } = visitor;
  await visitor.drop(glb, "dense.glb");
  await visitor.untilFace();
  await page.waitForSelector("#history .waits", { state: "attached" });
  assert.ok(await page.isHidden("#notice"));
  assert.equal(await page.inputValue("#density"), "3");
  const found = await visitor.meshJson("mm");
  assert.equal(found.positions.length, DENSEST);
  await visitor.unfold("section-history");
  const history = await visitor.history();
  assert.equal(history.length, 2);
  assert.match(history[1], /^point 20,000/);

  await visitor.move("bottom of the chin", "y", -6);
  const work = await visitor.meshJson("mm");
  assert.ok(furthest(found, work) > 3);
  assert.equal((await visitor.history()).length, 3);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), found);
  await page.click("#toolbar [data-action='redo']");
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.meshJson("mm"), work);
  assert.equal((await visitor.history()).length, 3);
  assert.equal(await page.locator("#history .waits").count(), 1);
});

test("a GLB whose texture another program has halved opens with the photo in its place", { tag: ["@eyes", "@rare"] }, async ({ open }) => {
  const { visitor, page, work } = await withAnEdit(open);
  const parts = partsOfGlb(await visitor.download("download-glb"));
  const at = parts.json.images[0].bufferView;
  const halved = withView(parts, at, await halfAsLarge(page, viewOf(parts, at)));
  await letGo(visitor);
  const view = await visitor.view();

  await page.reload();
  await visitor.drop(halved, "halved.glb");
  await visitor.untilFace();
  assert.deepEqual((await visitor.meshJson("mm")).positions, work.positions);
  await letGo(visitor);
  const opened = await visitor.view();
  for (const left of [0.38, 0.44, 0.5, 0.56]) {
    for (const top of [0.25, 0.45, 0.65]) {
      const patch = { left, top, right: left + 0.06, bottom: top + 0.08 };
      const [wanted, seen] = [meanColour(view, patch), meanColour(opened, patch)];
      const off = Math.max(...wanted.map((level, channel) => Math.abs(level - seen[channel])));
      assert.ok(off < 8, `colours are ${off} levels off at ${left}, ${top}`);
    }
  }
});

test("a GLB whose shape another program has changed opens as it was saved, and the page says so", async ({ open }) => {
  const { visitor, page, work } = await withAnEdit(open);
  const glb = await visitor.download("download-glb");
  const parts = partsOfGlb(glb);
  const at = parts.json.accessors[parts.json.meshes[0].primitives[0].attributes.POSITION].bufferView;
  const positions = Buffer.from(viewOf(parts, at));
  for (let place = 0; place < positions.length; place += 12) positions.writeFloatLE(1.3 * positions.readFloatLE(place), place);

  await visitor.drop(withView(parts, at, positions), "wider.glb");
  await page.waitForSelector("#notice[data-code='changed-elsewhere']");
  assert.match((await visitor.notice()).text, /changed by another program\s+It opens as it was saved here/);
  assert.deepEqual((await visitor.meshJson("mm")).positions, work.positions);
  await visitor.drop(glb, "as-saved.glb");
  await page.waitForSelector("#notice", { state: "hidden" });
  await visitor.untilFace();
  assert.ok(await page.isHidden("#notice"));
});

/** A visitor with one edit of the sample, and the mesh that it has led to. */
async function withAnEdit(open) {
  const visitor = await open();
  await visitor.openFace();
  await visitor.move("nose tip", "z", 6);
  return { visitor, page: visitor.page, work: await visitor.meshJson("mm") };
}

/** Nothing is selected any more, and the pointer is away: the view shows no marks. */
async function letGo(visitor) {
  const { x, y } = await visitor.besideTheFace();
  await visitor.page.mouse.click(x, y);
  await visitor.page.mouse.move(4, 4);
}

/** A picture at half its width and height, as a JPEG. */
async function halfAsLarge(page, bytes) {
  const base64 = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(picture.width / 2, picture.height / 2);
    canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
    const blob = await canvas.convertToBlob({ type: "image/jpeg", quality: 0.9 });
    return btoa(String.fromCharCode(...new Uint8Array(await blob.arrayBuffer())));
  }, bytes.toString("base64"));
  return Buffer.from(base64, "base64");
}
