import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { photoByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { asJpeg } from "./pictures.mjs";
import { difference, differenceNear, differingBox, largestStep } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

/** The portrait's nose, in px. */
const NOSE = { x: 225, y: 125 };
/** Bounds of the default falloff band around the portrait's face, px. */
const REACH = { left: 120, top: 20, right: 320, bottom: 250 };

const sample = async () => PNG.sync.read(await readFile(SAMPLE));

/** The photo as the page saves it. @param {import("./visitor.mjs").Visitor} visitor */
const photoOf = async (visitor) => PNG.sync.read(await visitor.download("download-photo-png"));

/** The photo as the command line saves it. @param {string[]} options */
const byCommandLine = async (options) => PNG.sync.read(await photoByCommandLine(SAMPLE, ["--topology", "canonical", ...options]));

test("an unedited photo is saved unchanged; edits stay within the falloff band and equal the command line's", { tag: "@usual" }, async ({ visitor }) => {
  await visitor.dropSample();
  const before = await sample();
  assert.deepEqual((await photoOf(visitor)).data, before.data);
  await visitor.setSlider("nose-width", -4);
  await visitor.setSlider("jaw-width", -6);
  const after = await photoOf(visitor);
  assert.ok(differenceNear(before, after, NOSE, 12) > 0.1, "the nose has not changed");
  const box = differingBox(before, after);
  assert.ok(box.left >= REACH.left && box.top >= REACH.top && box.right <= REACH.right && box.bottom <= REACH.bottom, JSON.stringify(box));
  await visitor.setSlider("chin-length", 6);
  const sliders = ["nose-width:-4", "jaw-width:-6", "chin-length:6"].flatMap((slider) => ["--slider", slider]);
  const step = largestStep(await photoOf(visitor), await byCommandLine(sliders));
  assert.ok(step <= 1, String(step));
});

test("a wider falloff band moves more of the photo", async ({ editor }) => {
  await editor.setSlider("face-length", 8);
  const widths = [];
  for (const share of [10, 35, 80]) {
    await editor.unfold("section-in-photo");
    await editor.page.locator("#in-photo-ring .number-field").fill(String(share));
    await editor.page.keyboard.press("Tab");
    const { left, right } = differingBox(await sample(), await photoOf(editor));
    widths.push(right - left);
  }
  assert.ok(widths[0] + 20 < widths[1] && widths[1] + 20 < widths[2], JSON.stringify(widths));
});

test("the photo can be viewed from further away, from nearer, and as taken", async ({ editor }) => {
  const photos = [];
  for (const cm of [30, 300]) {
    await editor.unfold("section-in-photo");
    await editor.page.locator("#in-photo-distance .number-field").fill(String(cm));
    await editor.page.keyboard.press("Tab");
    photos.push(await photoOf(editor));
    assert.ok(largestStep(photos.at(-1), await byCommandLine(["--seen-from", String(cm)])) <= 1, `${cm} cm`);
  }
  assert.ok(differenceNear(photos[0], photos[1], NOSE, 40) > 0.2);
  await editor.unfold("section-in-photo");
  await editor.page.click("#in-photo-as-taken");
  assert.equal(difference(await photoOf(editor), await sample()), 0);
});

test("a transparent photo stays transparent as PNG, and becomes white as JPEG", async ({ visitor }) => {
  const before = await sample();
  for (let pixel = 0; pixel < before.width * before.height; pixel++) {
    if (pixel % before.width >= before.width - 100) before.data[4 * pixel + 3] = 0;
  }
  await visitor.drop(PNG.sync.write(before), "cut-out.png");
  await visitor.untilFace();
  await visitor.setSlider("nose-width", -4);
  const after = await photoOf(visitor);
  for (const [x, alpha] of [[9, 255], [before.width - 9, 0]]) assert.equal(after.data[4 * (40 * before.width + x) + 3], alpha, `alpha at ${x}`);
  const { colour } = await decoded(visitor.page, await visitor.download("download-photo-jpeg"));
  assert.ok(Math.min(...colour) > 250, `${colour}`);
});

test("a 12-megapixel photo is saved at full size, upright and without EXIF data", async ({ visitor, page }) => {
  await visitor.drop(withExif(await asJpeg(page, await readFile(SAMPLE), { width: 4000, height: 3000 })), "selfie.jpg");
  await visitor.untilFace();
  const before = await photoOf(visitor);
  await visitor.setSlider("nose-width", -4);
  const after = await photoOf(visitor);
  assert.deepEqual([after.width, after.height], [4000, 3000]);
  const box = differingBox(before, after);
  assert.ok(box.right - box.left > 150 && box.right - box.left < 1800, JSON.stringify(box));
  const jpeg = await visitor.download("download-photo-jpeg");
  assert.equal(jpeg.subarray(0, 2).toString("hex"), "ffd8");
  for (const secret of ["Exif", "GPS", "Somewhere"]) assert.ok(!jpeg.includes(secret), secret);
  const { width, height } = await decoded(page, jpeg);
  assert.deepEqual([width, height], [4000, 3000]);
});

/** Size of a picture, and colour of a pixel near its upper right corner. */
function decoded(page, bytes) {
  return page.evaluate(async (bytes) => {
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const { width, height } = bitmap;
    const context = new OffscreenCanvas(width, height).getContext("2d");
    context.drawImage(bitmap, 0, 0);
    return { width, height, colour: [...context.getImageData(width - 9, 40, 1, 1).data] };
  }, new Uint8Array(bytes));
}

/** A JPEG with an EXIF segment that contains a location. @param {Buffer} jpeg */
function withExif(jpeg) {
  const tiff = Buffer.concat([Buffer.from("Exif\0\0MM\0\x2a\0\0\0\x08\0\0\0\0\0\0", "latin1"), Buffer.from("GPS Somewhere")]);
  const head = Buffer.from([0xff, 0xe1, 0, 0]);
  head.writeUInt16BE(tiff.length + 2, 2);
  return Buffer.concat([jpeg.subarray(0, 2), head, tiff, jpeg.subarray(2)]);
}
