import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { photoByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { asJpeg } from "./pictures.mjs";
import { difference, differenceNear, differingBox, largestStep } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

/** Where the portrait's nose is, in its px, and a place beyond the ring around the face. */
const NOSE = { x: 225, y: 125 };
/** What the ring of the usual width can reach at most around the portrait's face, px. */
const REACH = { left: 120, top: 20, right: 320, bottom: 250 };

const sample = async () => PNG.sync.read(await readFile(SAMPLE));

test("without an edit the photo leaves the page as it came, byte for byte", async ({ visitor }) => {
  await visitor.dropSample();
  const file = PNG.sync.read(await visitor.download("download-photo-png"));
  assert.deepEqual(Buffer.from(file.data), Buffer.from((await sample()).data));
});

test("an edit changes the photo where the face is, and nothing beyond the ring", async ({ editor }) => {
  await editor.slide("nose-width", -4);
  await editor.slide("jaw-width", -6);
  const before = await sample();
  const after = PNG.sync.read(await editor.download("download-photo-png"));
  assert.ok(differenceNear(before, after, NOSE, 12) > 0.1, "the nose is as it was");
  const box = differingBox(before, after);
  assert.ok(box.left >= REACH.left && box.top >= REACH.top && box.right <= REACH.right && box.bottom <= REACH.bottom, JSON.stringify(box));
});

test("a wider ring gives way further, and a narrow one less", { tag: "@rare" }, async ({ editor }) => {
  await editor.slide("face-length", 8);
  const widths = [];
  for (const share of [10, 35, 80]) {
    await editor.unfold("section-in-photo");
    await editor.page.locator("#in-photo-ring input[type=number]").fill(String(share));
    await editor.page.keyboard.press("Tab");
    const { left, right } = differingBox(await sample(), PNG.sync.read(await editor.download("download-photo-png")));
    widths.push(right - left);
  }
  assert.ok(widths[0] + 20 < widths[1] && widths[1] + 20 < widths[2], JSON.stringify(widths));
});

test("the page and the command line write the same photo", async ({ visitor }) => {
  await visitor.dropSample();
  await visitor.slide("nose-width", -4);
  await visitor.slide("chin-length", 6);
  const ours = PNG.sync.read(await visitor.download("download-photo-png"));
  const theirs = await photoByCommandLine(SAMPLE, ["--topology", "canonical", "--slider", "nose-width:-4", "--slider", "chin-length:6"]);
  const step = largestStep(ours, PNG.sync.read(theirs));
  assert.ok(step <= 1, String(step));
});

test("the face seen from further away, from nearer, and as it was taken", { tag: "@rare" }, async ({ editor }) => {
  const photos = [];
  for (const cm of [30, 300]) {
    await editor.unfold("section-in-photo");
    await editor.page.locator("#in-photo-distance input[type=number]").fill(String(cm));
    await editor.page.keyboard.press("Tab");
    photos.push(PNG.sync.read(await editor.download("download-photo-png")));
    const theirs = PNG.sync.read(await photoByCommandLine(SAMPLE, ["--topology", "canonical", "--seen-from", String(cm)]));
    assert.ok(largestStep(photos.at(-1), theirs) <= 1, `${cm} cm`);
  }
  assert.ok(differenceNear(photos[0], photos[1], NOSE, 40) > 0.2);
  await editor.unfold("section-in-photo");
  await editor.page.click("#seen-as-taken");
  assert.equal(difference(PNG.sync.read(await editor.download("download-photo-png")), await sample()), 0);
});

test("a transparent photo leaves the page transparent as a PNG, and over white as a JPEG", async ({ visitor }) => {
  const before = await sample();
  const transparent = (/** @type {number} */ x) => x >= before.width - 100;
  for (let pixel = 0; pixel < before.width * before.height; pixel++) {
    if (transparent(pixel % before.width)) before.data[4 * pixel + 3] = 0;
  }
  await visitor.drop(PNG.sync.write(before), "cut-out.png");
  await visitor.untilFace();
  await visitor.slide("nose-width", -4);
  const after = PNG.sync.read(await visitor.download("download-photo-png"));
  for (const [x, alpha] of [[9, 255], [before.width - 9, 0]]) assert.equal(after.data[4 * (40 * before.width + x) + 3], alpha, `alpha at ${x}`);
  const jpeg = await visitor.download("download-photo-jpeg");
  const [red, green, blue] = await visitor.page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
    context?.drawImage(bitmap, 0, 0);
    return [...(context?.getImageData(bitmap.width - 9, 40, 1, 1).data ?? [])];
  }, jpeg.toString("base64"));
  assert.ok(Math.min(red, green, blue) > 250, `${red}, ${green}, ${blue}`);
});

test("a JPEG comes out upright and says nothing of where it was taken", async ({ visitor }) => {
  const jpeg = withExif(await asJpeg(visitor.page, await readFile(SAMPLE)));
  await visitor.drop(jpeg, "selfie.jpg");
  await visitor.untilFace();
  await visitor.slide("nose-width", -4);
  const file = await visitor.download("download-photo-jpeg");
  assert.equal(file.subarray(0, 2).toString("hex"), "ffd8");
  for (const secret of ["Exif", "GPS", "Somewhere"]) assert.ok(!file.includes(secret), secret);
  const size = await visitor.page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const { width, height } = await createImageBitmap(new Blob([bytes]));
    return { width, height };
  }, file.toString("base64"));
  assert.deepEqual(size, { width: 512, height: 512 });
});

test("a photo of twelve megapixels comes out whole", async ({ visitor }) => {
  const jpeg = await asJpeg(visitor.page, await readFile(SAMPLE), { width: 4000, height: 3000 });
  await visitor.drop(jpeg, "large.jpg");
  await visitor.untilFace();
  const before = PNG.sync.read(await visitor.download("download-photo-png"));
  await visitor.slide("nose-width", -4);
  const after = PNG.sync.read(await visitor.download("download-photo-png"));
  assert.deepEqual([after.width, after.height], [4000, 3000]);
  const box = differingBox(before, after);
  assert.ok(box.right - box.left > 150 && box.right - box.left < 1800, JSON.stringify(box));
});

/** A JPEG with an EXIF segment that says where it was taken, as text. @param {Buffer} jpeg */
function withExif(jpeg) {
  const tiff = Buffer.concat([Buffer.from("Exif\0\0MM\0\x2a\0\0\0\x08\0\0\0\0\0\0", "latin1"), Buffer.from("GPS Somewhere")]);
  const head = Buffer.from([0xff, 0xe1, 0, 0]);
  head.writeUInt16BE(tiff.length + 2, 2);
  return Buffer.concat([jpeg.subarray(0, 2), head, tiff, jpeg.subarray(2)]);
}
