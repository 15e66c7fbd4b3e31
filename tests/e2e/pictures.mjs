import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { PNG } from "pngjs";
import { crc32 } from "node:zlib";
import { SAMPLE } from "./visitor.mjs";

/** Bounds of the head in the sample portrait, px. */
const FACE_IN_PORTRAIT = { x: 110, y: 10, width: 220, height: 220 };

/** Upper part of the sample portrait in a camera's aspect ratio, px. */
const UPPER_PART = { x: 0, y: 0, width: 512, height: 384 };

/** A picture without a face. */
export function faceless() {
  const png = new PNG({ width: 320, height: 240 });
  for (let i = 0; i < png.data.length; i += 4) {
    const x = (i / 4) % png.width;
    png.data.set([x % 256, 160, 255 - (x % 256), 255], i);
  }
  return PNG.sync.write(png);
}

/** Draws dots on a picture. @param {Uint8Array} png @param {{ x: number, y: number, colour: number[] }[]} dots in px */
export function dotted(png, dots, radius_px) {
  const picture = PNG.sync.read(Buffer.from(png));
  for (let at = 0; at < picture.data.length; at += 4) {
    const [column, row] = [(at / 4) % picture.width, Math.floor(at / 4 / picture.width)];
    const dot = dots.find(({ x, y }) => Math.hypot(column + 0.5 - x, row + 0.5 - y) < radius_px);
    if (dot) picture.data.set(dot.colour, at);
  }
  return PNG.sync.write(picture);
}

/** A text file, to be named .jpg. */
export function text() {
  return Buffer.from("Dear diary, today I was renamed to a photo.\n".repeat(40));
}

/** Start of a HEIC file as written by an iPhone. */
export function heic() {
  return Buffer.concat([Buffer.from("\0\0\0\x18ftypheic\0\0\0\0mif1heic", "latin1"), Buffer.alloc(200)]);
}

/** A PNG whose header declares 20 000 × 20 000 px. */
export function enormousPng() {
  const png = PNG.sync.write(new PNG({ width: 1, height: 1 }));
  png.writeUInt32BE(20_000, 16);
  png.writeUInt32BE(20_000, 20);
  png.writeUInt32BE(crc32(png.subarray(12, 29)), 29);
  return png;
}

/** @typedef {import("@playwright/test").Page} Page draws the picture */

/**
 * Encodes the photo as JPEG; with a size in px, crops it to the portrait's upper part.
 *
 * @param {Page} page
 * @param {Uint8Array} png
 */
export function asJpeg(page, png, size) {
  return redraw(page, png, { type: "image/jpeg", size, part: size && UPPER_PART });
}

/** The same face twice, side by side. @param {Page} page @param {Uint8Array} png */
export function twice(page, png) {
  return redraw(page, png, { columns: 2, part: FACE_IN_PORTRAIT });
}

/** The same face six times, in two rows. @param {Page} page @param {Uint8Array} png */
export function sixTimes(page, png) {
  return redraw(page, png, { columns: 3, rows: 2, part: FACE_IN_PORTRAIT });
}

/** Blurred so that detection is uncertain. @param {Page} page @param {Uint8Array} png */
export function outOfFocus(page, png) {
  return redraw(page, png, { filter: "blur(5px)" });
}

async function redraw(page, png, how) {
  const bytes = await page.evaluate(
    async ({ png, type = "image/png", columns = 1, rows = 1, size, part, filter = "none" }) => {
      const picture = await createImageBitmap(new Blob([png]));
      const from = part ?? { x: 0, y: 0, width: picture.width, height: picture.height };
      const { width, height } = size ?? { width: columns * from.width, height: rows * from.height };
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext("2d");
      context.filter = filter;
      const copy = { width: width / columns, height: height / rows };
      for (let at = 0; at < columns * rows; at++) {
        const place = { left: (at % columns) * copy.width, top: Math.floor(at / columns) * copy.height };
        context.drawImage(picture, from.x, from.y, from.width, from.height, place.left, place.top, copy.width, copy.height);
      }
      const blob = await canvas.convertToBlob({ type, quality: 0.9 });
      return new Uint8Array(await blob.arrayBuffer());
    },
    { png: new Uint8Array(png), ...how },
  );
  return Buffer.from(bytes);
}

/** A .y4m video of the sample portrait for a fake camera. */
export async function portraitVideo() {
  const picture = PNG.sync.read(await readFile(SAMPLE));
  const header = Buffer.from(`YUV4MPEG2 W${picture.width} H${picture.height} F25:1 Ip A1:1 C420\n`);
  const file = path.join(await mkdtemp(path.join(tmpdir(), "rosto-")), "portrait.y4m");
  await writeFile(file, Buffer.concat([header, ...new Array(5).fill(yuvOf(picture))]));
  return file;
}

/**
 * A frame of a .y4m file in YUV 4:2:0.
 *
 * @param {{ width: number, height: number, data: Uint8Array | Uint8ClampedArray }} picture RGBA
 */
export function yuvOf({ width, height, data }) {
  const luma = Buffer.alloc(width * height);
  const blue = Buffer.alloc((width / 2) * (height / 2));
  const red = Buffer.alloc(blue.length);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const at = 4 * (y * width + x);
      const [r, g, b] = data.subarray(at, at + 3);
      luma[y * width + x] = 16 + 0.257 * r + 0.504 * g + 0.098 * b;
      const half = (y >> 1) * (width / 2) + (x >> 1);
      blue[half] = 128 - 0.148 * r - 0.291 * g + 0.439 * b;
      red[half] = 128 + 0.439 * r - 0.368 * g - 0.071 * b;
    }
  }
  return Buffer.concat([Buffer.from("FRAME\n"), luma, blue, red]);
}
