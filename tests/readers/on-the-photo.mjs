// Asserts that a face drawn by three.js with the photo's camera matches the photo.
import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { Euler, MathUtils, Matrix3, Matrix4, Vector3 } from "three";
import { urlOf } from "./chromium.mjs";
import { FOLDER, SAMPLE, shapeOf } from "./files.mjs";

/** Angles are rounded to 0.01°, which is about 0.01 px across a face. */
const MAX_OFF_PX = 0.1;
/** Share of the landmarks that face the camera of the sample portrait, and rounds in which they are found. */
const FACING = 0.7;
const ROUNDS = 20;
/** At the border, triangles end inside a pixel, and the photo's background shows. */
const BORDER_PX = 2;
/** Offset of the landmarks in a photo's bytes: see docs/formats.md. */
const LANDMARKS_AT = 11;
/** A face of 128 px has 16 000. */
const MIN_PIXELS = 5_000;
/** By one pixel to the left, right, top and bottom. */
const SHIFTS = [[-1, 0], [1, 0], [0, -1], [0, 1]];

/** @typedef {typeof import("./table.mjs").ON_THE_PHOTO[number]} Row */

/** Asserts that three.js draws a file where the photo shows the face. @param {{ row: Row, path: string }} file */
export async function assertOnThePhoto({ module, remarks }, { row, path: file }) {
  const photo = PNG.sync.read(await readFile(SAMPLE));
  const { matrix, focal_px, off_px } = await photoCamera(file, row.shape, photo);
  const camera = { width: photo.width, height: photo.height, focal_px, cameraFromModel: matrix.toArray() };
  const drawn = await module.evaluate(({ draw }, [url, how]) => draw(url, how), /** @type {const} */ ([urlOf(file), camera]));
  const bytes = Buffer.from(drawn.split(",")[1], "base64");
  await writeFile(path.join(FOLDER, `on-the-photo-${path.basename(file)}.png`), bytes);
  const picture = PNG.sync.read(bytes);
  const { pixels, off } = difference(picture, photo);
  const shifted = Math.min(...SHIFTS.map((shift) => difference(picture, photo, shift).off));
  assert.deepEqual(remarks.splice(0), []);
  assert.ok(off_px < MAX_OFF_PX, `a landmark is ${off_px} px from its position in the photo`);
  assert.ok(pixels >= MIN_PIXELS, `only ${pixels} pixels show the face`);
  assert.ok(off < row.most, `mean colour error ${off} of 255; at most ${row.most}`);
  assert.ok(off < shifted, `the error is smaller one pixel aside: ${shifted}, not ${off}`);
}

/** Camera from the GLB's extras, and the largest distance of a landmark that faces it from its position in the photo. */
async function photoCamera(file, shape, { width, height }) {
  const glb = await readFile(file);
  const { about, photos: [{ observation }] } = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString()).scenes[0].extras;
  const { positions } = await shapeOf({ ...shape, density: 0, edits: [] });
  const bytes = Buffer.from(observation, "base64").subarray(LANDMARKS_AT);
  const photo_px = positions.map((_, at) => [(bytes.readFloatLE(12 * at) - 0.5) * width, (0.5 - bytes.readFloatLE(12 * at + 4)) * height]);
  // Intrinsic rotations: yaw about +Y, then pitch about +X, then roll about +Z.
  const [pitch, yaw, roll] = [about.pitch_deg, about.yaw_deg, about.roll_deg].map(MathUtils.degToRad);
  const matrix = new Matrix4().makeRotationFromEuler(new Euler(pitch, yaw, roll, "YXZ"));
  const turned = positions.map((point) => new Vector3(...point).divideScalar(1000).applyMatrix4(matrix));
  const offsets = (/** @type {import("three").Vector3} */ moved) =>
    turned.map((point, at) => {
      const { x, y, z } = point.clone().add(moved);
      return Math.hypot((about.focal_px * x) / -z - photo_px[at][0], (about.focal_px * y) / -z - photo_px[at][1]);
    });
  // Landmarks that do not face the camera have left their rays: the fit is repeated with the nearest ones.
  let near = turned.map((_, at) => at);
  let moved = translation(about.focal_px, turned, photo_px, near);
  for (let round = 0; round < ROUNDS; round += 1) {
    const offs_px = offsets(moved);
    near = turned.map((_, at) => at).sort((a, b) => offs_px[a] - offs_px[b]).slice(0, FACING * turned.length);
    moved = translation(about.focal_px, turned, photo_px, near);
  }
  const offs_px = offsets(moved);
  const off_px = Math.max(...near.map((at) => offs_px[at]));
  return { matrix: matrix.setPosition(moved), focal_px: about.focal_px, off_px };
}

/** Translation that puts landmarks on their rays, by least squares: `u = −f (x + tx) / (z + tz)` and likewise `v`, linearised. */
function translation(focal_px, turned, photo_px, near) {
  const rows = near.flatMap((at) => {
    const { x, y, z } = turned[at];
    const [u, v] = photo_px[at];
    return [[focal_px, 0, u, -u * z - focal_px * x], [0, focal_px, v, -v * z - focal_px * y]];
  });
  const product = (i, j) => rows.reduce((sum, row) => sum + row[i] * row[j], 0);
  const normal = [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => product(i, j)));
  return new Vector3(product(0, 3), product(1, 3), product(2, 3)).applyMatrix3(new Matrix3(...normal).invert());
}

/** Number of pixels that a drawn face covers without its border, and their mean difference from the photo shifted by some px. */
function difference(drawn, photo, [dx, dy] = [0, 0]) {
  let [pixels, sum] = [0, 0];
  const around = [-BORDER_PX, 0, BORDER_PX];
  for (let y = BORDER_PX; y < drawn.height - BORDER_PX; y += 1) {
    for (let x = BORDER_PX; x < drawn.width - BORDER_PX; x += 1) {
      if (around.some((down) => around.some((right) => drawn.data[4 * ((y + down) * drawn.width + x + right) + 3] < 255))) continue;
      pixels += 1;
      const [here, there] = [4 * (y * drawn.width + x), 4 * ((y + dy) * drawn.width + x + dx)];
      for (const channel of [0, 1, 2]) sum += Math.abs(drawn.data[here + channel] - photo.data[there + channel]) / 3;
    }
  }
  return { pixels, off: sum / pixels };
}
