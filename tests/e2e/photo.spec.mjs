import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { asJpeg, dotted } from "./pictures.mjs";
import { colourCount, difference, middleOf } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

/** Landmarks far from each other, each with a colour that no skin has. */
const APART = /** @type {const} */ ([[151, [0, 200, 60]], [50, [30, 60, 255]], [280, [0, 220, 230]], [199, [240, 240, 0]]]);
/** Width and height of the sample. */
const SIDE_PX = 512;

/** Maximum size at which the panel shows a photo. */
const MAX_SHOWN_PX = 640 * 320;

/** x of the nose in the portrait, as a fraction of the width. */
const NOSE_IN_PORTRAIT = 0.44;

test("a selfie from the camera opens unmirrored, and is named selfie", { tag: ["@camera", "@usual"] }, async ({ visitor }) => {
  await visitor.page.click("#welcome [data-action='camera']");
  const mirrored = await visitor.page.locator("#camera-preview").evaluate((video) => getComputedStyle(video).scale);
  assert.equal(mirrored, "-1 1");
  await visitor.page.click("#camera-shutter:enabled");
  await visitor.page.waitForFunction(() => /[123]/.test(document.getElementById("camera-countdown").textContent));
  await visitor.untilFace();
  assert.ok(await visitor.page.locator("#camera").isHidden());

  // Mirrored, the nose would be in the other half of the picture.
  const nose = (await visitor.meshJson("image")).positions[1];
  assert.ok(Math.abs(nose[0] - NOSE_IN_PORTRAIT) < 0.03, `the nose is at ${nose[0]} of the width`);
  assert.equal((await visitor.save("save-project")).name, "selfie.rosto");
});

test("the hovered landmark is marked on the panel's photo and on the mesh", async ({ visitor, page }) => {
  const { positions } = await meshByCommandLine(SAMPLE, ["--units", "image"]);
  const dots = APART.map(([landmark, colour]) => ({ x: positions[landmark][0] * SIDE_PX, y: positions[landmark][1] * SIDE_PX, colour }));
  await visitor.drop(dotted(await readFile(SAMPLE), dots, 4), "dotted.png");
  await visitor.untilFace();
  await visitor.selectBy("landmark");
  await visitor.unfold("section-photo");
  const photo = page.locator("#photo-picture");
  await photo.scrollIntoViewIfNeeded();
  const box = await photo.boundingBox();
  const view = await page.locator("#viewport").boundingBox();
  const picture = PNG.sync.read(await photo.screenshot());
  assert.ok(colourCount(picture) > 100);
  for (const [landmark, colour] of APART) {
    const dot = middleOf(picture, colour, 60);
    assert.ok(dot.x > 0, `the dot on ${landmark} is not shown`);
    await page.mouse.move(box.x + dot.x, box.y + dot.y);
    await visitor.frames(2);
    assert.match(await page.innerText("#landmark-tag"), new RegExp(` · ${landmark}$`), `at ${dot.x}, ${dot.y}`);
    const { x } = await page.locator("#landmark-tag").boundingBox();
    assert.ok(x > view.x && x < view.x + view.width, "the tag is not on the mesh");
  }
  await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
  await visitor.frames(2);
  assert.ok(difference(picture, PNG.sync.read(await photo.screenshot())) > 0, "the photo does not mark the landmark");
});

test("the main thread draws a large photo only at its displayed size", async ({ open }) => {
  const visitor = await open({ scripts: [recordDrawnImages] });
  const { page } = visitor;
  // Before the host is open, an unscaled part of the photo is drawn.
  await visitor.untilLoaded();
  await visitor.drop(await asJpeg(page, await readFile(SAMPLE), { width: 4000, height: 3000 }), "large.jpg");
  await visitor.untilFace();
  await visitor.unfold("section-photo");
  await visitor.frames(3);
  const drawn = await page.evaluate(() => globalThis.drawn);
  assert.ok(drawn.length >= 2, "neither the row's picture nor the photo is drawn");
  assert.ok(Math.max(...drawn) <= MAX_SHOWN_PX, `pictures of ${drawn} px are drawn`);
});

/**
 * Runs in the page: records the size in px of each image passed to `drawImage` on a canvas element. Delays animation frames, so
 * that the panel also draws the photo before the first frame has applied the edits.
 */
function recordDrawnImages() {
  const { requestAnimationFrame } = globalThis;
  globalThis.requestAnimationFrame = (act) => requestAnimationFrame(() => setTimeout(() => act(performance.now()), 200));
  const { drawImage } = CanvasRenderingContext2D.prototype;
  globalThis.drawn = [];
  CanvasRenderingContext2D.prototype.drawImage = function (picture, ...places) {
    globalThis.drawn.push(picture.width * picture.height);
    drawImage.call(this, picture, ...places);
  };
}
