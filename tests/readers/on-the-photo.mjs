// A face drawn by three.js as the photo's camera saw it lies on the photo.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { Euler, MathUtils, Matrix3, Matrix4, Vector3 } from "three";
import { openPage, urlOf } from "./chromium.mjs";
import { FOLDER, SAMPLE, shapeOf, written } from "./files.mjs";

/** @typedef {import("../journeys/pixels.mjs").Pixels} Pixels */

/** Angles are rounded to a hundredth of a degree, which is a hundredth of a px across a face. */
const MOST_OFF_PX = 0.1;
/** The border shows the photo's background where a triangle ends between two pixels. */
const BORDER_PX = 2;
/** A face of 128 px has 16 000. */
const LEAST_PIXELS = 5_000;
/** Left, right, up and down by a pixel. */
const SHIFTS = [[-1, 0], [1, 0], [0, -1], [0, 1]];

/** The faults of each row's file. @param {typeof import("./table.mjs").ON_THE_PHOTO} rows */
export async function* faultsOnThePhoto(rows) {
  const photo = PNG.sync.read(await readFile(SAMPLE));
  const files = await written(rows.map(({ row }) => row));
  const open = await openPage();
  for (const [at, file] of files.entries()) {
    const name = path.basename(file.path);
    yield { name, faults: await faultsOf(open, file, rows[at].most, photo) };
  }
  await open.close();
}

async function faultsOf({ page, remarks }, { row, path: file }, most, photo) {
  const { width, height } = photo;
  const { matrix, focal_px, off_px } = await photoCamera(file, row.shape, photo);
  const camera = { width, height, focal_px, cameraFromModel: matrix.toArray() };
  const drawn = await page.evaluate(async ([url, how]) => {
    const three = await import("/tests/readers/chromium/three-draws.mjs");
    return three.draw(url, how);
  }, /** @type {const} */ ([urlOf(file), camera]));
  const picture = Object.assign(new PNG({ width, height }), { data: Buffer.from(drawn, "base64") });
  await writeFile(path.join(FOLDER, `on-the-photo-${path.basename(file)}.png`), PNG.sync.write(picture));
  const { pixels, off } = difference(picture, photo);
  const shifted = Math.min(...SHIFTS.map((shift) => difference(picture, photo, shift).off));
  return [
    ...remarks(),
    ...(off_px < MOST_OFF_PX ? [] : [`a landmark is ${off_px} px from its place in the photo`]),
    ...(pixels >= LEAST_PIXELS ? [] : [`only ${pixels} pixels show the face`]),
    ...(off < most ? [] : [`colours ${off} off the photo's in the mean, of 255; at most ${most}`]),
    ...(off < shifted ? [] : [`a pixel aside it fits the photo better: ${shifted} off, not ${off}`]),
  ];
}

/** The photo's camera from the GLB's extras, and the largest distance of a landmark from its place in the photo. */
async function photoCamera(file, shape, { width, height }) {
  const { about, landmarks } = jsonOf(await readFile(file)).scenes[0].extras;
  const { positions } = await shapeOf({ ...shape, density: 0, edits: "none" });
  const bytes = Buffer.from(landmarks, "base64");
  const seen_px = positions.map((_, at) => [(bytes.readFloatLE(12 * at) - 0.5) * width, (0.5 - bytes.readFloatLE(12 * at + 4)) * height]);
  // Yaw about +Y, then pitch about +X, then roll about +Z, each in the frame that the one before it left.
  const [pitch, yaw, roll] = [about.pitch_deg, about.yaw_deg, about.roll_deg].map(MathUtils.degToRad);
  const matrix = new Matrix4().makeRotationFromEuler(new Euler(pitch, yaw, roll, "YXZ"));
  const turned = positions.map((point) => new Vector3(...point).divideScalar(1000).applyMatrix4(matrix));
  const moved = translation(about.focal_px, turned, seen_px);
  const offs_px = turned.map((point, at) => {
    const { x, y, z } = point.clone().add(moved);
    return Math.hypot((about.focal_px * x) / -z - seen_px[at][0], (about.focal_px * y) / -z - seen_px[at][1]);
  });
  return { matrix: matrix.setPosition(moved), focal_px: about.focal_px, off_px: Math.max(...offs_px) };
}

/** Puts the landmarks on their rays by least squares: `u = −f (x + tx) / (z + tz)`, likewise `v`, times the denominator. */
function translation(focal_px, turned, seen_px) {
  const rows = turned.flatMap(({ x, y, z }, at) => {
    const [u, v] = seen_px[at];
    return [[focal_px, 0, u, -u * z - focal_px * x], [0, focal_px, v, -v * z - focal_px * y]];
  });
  const product = (i, j) => rows.reduce((sum, row) => sum + row[i] * row[j], 0);
  const normal = [0, 1, 2].flatMap((i) => [0, 1, 2].map((j) => product(i, j)));
  return new Vector3(product(0, 3), product(1, 3), product(2, 3)).applyMatrix3(new Matrix3(...normal).invert());
}

/** The JSON of a GLB. @param {Buffer} bytes */
function jsonOf(bytes) {
  return JSON.parse(bytes.subarray(20, 20 + bytes.readUInt32LE(12)).toString());
}

/**
 * Where the drawn face covers the photo, without its border: the number of pixels, and their mean difference from the photo's,
 * shifted.
 *
 * @param {Pixels} drawn
 * @param {Pixels} photo
 * @param {number[]} shift px
 */
function difference(drawn, photo, [dx, dy] = [0, 0]) {
  let [pixels, sum] = [0, 0];
  for (let y = BORDER_PX; y < drawn.height - BORDER_PX; y += 1) {
    for (let x = BORDER_PX; x < drawn.width - BORDER_PX; x += 1) {
      if (!isWithin(drawn, x, y)) continue;
      pixels += 1;
      const [here, there] = [4 * (y * drawn.width + x), 4 * ((y + dy) * drawn.width + x + dx)];
      for (const channel of [0, 1, 2]) sum += Math.abs(drawn.data[here + channel] - photo.data[there + channel]) / 3;
    }
  }
  return { pixels, off: sum / pixels };
}

function isWithin({ width, data }, x, y) {
  const steps = [-BORDER_PX, 0, BORDER_PX];
  return steps.every((dy) => steps.every((dx) => data[4 * ((y + dy) * width + x + dx) + 3] === 255));
}
