// A face that three.js draws, seen by the camera that took the photo, lies on the photo.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { SAMPLE } from "../journeys/visitor.mjs";
import { cameraOf } from "./camera.mjs";
import { openPage, urlOf } from "./chromium.mjs";
import { FOLDER, shapeAsJson, written } from "./files.mjs";
import { jsonOf, rowsOf } from "./glb-extras.mjs";
import { ON_THE_PHOTO } from "./table.mjs";

/** @typedef {import("../journeys/pixels.mjs").Pixels} Pixels */

/** Angles are told to a hundredth of a degree, which is a hundredth of a px across a face. */
const MOST_OFF_PX = 0.1;
/** The border shows the photo's background where a triangle ends between two pixels. */
const BORDER_PX = 2;
/** A face of 128 px has 16 000. */
const LEAST_PIXELS = 5_000;

/** A px to the left, right, top and bottom. */
const BESIDE = [[-1, 0], [1, 0], [0, -1], [0, 1]];

/** What came of a file. @typedef {{ name: string, landmarks_px: number, pixels: number, off: number, beside: number, findings: string[] }} Laid */

/** @returns {Promise<Laid[]>} */
export async function onThePhoto() {
  const photo = PNG.sync.read(await readFile(SAMPLE));
  const files = await written(ON_THE_PHOTO.map(({ row }) => row));
  const open = await openPage();
  const all = [];
  for (const [at, file] of files.entries()) all.push(await laid(open, file, ON_THE_PHOTO[at], photo));
  await open.close();
  return all;
}

async function laid({ page, remarks }, file, { row, most }, photo) {
  const name = path.basename(file.path);
  const { matrix, errors_px, focal_px } = await photoCamera(file, row, photo);
  const landmarks_px = errors_px.reduce((a, b) => Math.max(a, b));
  const camera = { width: photo.width, height: photo.height, focal_px, cameraFromModel: matrix };
  const drawn = await page.evaluate(async ([url, how]) => {
    const three = await import("/tests/readers/chromium/three-draws.mjs");
    return three.draw(url, how);
  }, /** @type {const} */ ([urlOf(file.path), camera]));
  const picture = { width: photo.width, height: photo.height, data: new Uint8Array(Buffer.from(drawn, "base64")) };
  await keep(name, picture);
  const { pixels, off } = difference(picture, photo);
  const beside = BESIDE.map((step) => difference(picture, photo, step).off).reduce((a, b) => Math.min(a, b));
  const findings = [
    ...remarks(),
    ...(landmarks_px < MOST_OFF_PX ? [] : [`a landmark is ${landmarks_px} px from where the photo shows it`]),
    ...(pixels >= LEAST_PIXELS ? [] : [`only ${pixels} pixels show the face`]),
    ...(off < most ? [] : [`the colours are ${off} off the photo's in the mean, of 255; the most is ${most}`]),
    ...(off < beside ? [] : [`a px away from where it is, it would lie better on the photo: ${beside} off, not ${off}`]),
  ];
  return { name, landmarks_px, pixels, off, beside, findings };
}

/** The photo's camera as the file tells of it, which does not depend on how densely the face is cut up. */
async function photoCamera(file, { shape }, { width, height }) {
  const { extras } = jsonOf(await readFile(file.path)).scenes[0];
  const { positions } = await shapeAsJson({ ...shape, density: 0, edits: "none" });
  const landmarks = rowsOf(extras.landmarks, 3).slice(0, positions.length);
  const seen_px = landmarks.map(([x, y]) => [(x - 0.5) * width, (0.5 - y) * height]);
  const positions_m = positions.map((point) => point.map((value) => value / 1000));
  return { ...cameraOf(extras.about, positions_m, seen_px), focal_px: extras.about.focal_px };
}

/**
 * Where the drawn face covers the photo, its border apart: how many pixels, and by how much they differ from the photo's a step
 * away.
 *
 * @param {Pixels} drawn
 * @param {Pixels} photo
 * @param {number[]} step px
 */
function difference(drawn, photo, [dx, dy] = [0, 0]) {
  let [pixels, sum] = [0, 0];
  for (let y = BORDER_PX; y < drawn.height - BORDER_PX; y += 1) {
    for (let x = BORDER_PX; x < drawn.width - BORDER_PX; x += 1) {
      if (!isWithin(drawn, x, y)) continue;
      const at = 4 * (y * drawn.width + x);
      pixels += 1;
      const there = 4 * ((y + dy) * drawn.width + x + dx);
      for (const channel of [0, 1, 2]) sum += Math.abs(drawn.data[at + channel] - photo.data[there + channel]) / 3;
    }
  }
  return { pixels, off: sum / pixels };
}

function isWithin({ width, data }, x, y) {
  const steps = [-BORDER_PX, 0, BORDER_PX];
  return steps.every((dy) => steps.every((dx) => data[4 * ((y + dy) * width + x + dx) + 3] === 255));
}

/** For people: what was drawn. */
async function keep(name, picture) {
  const png = new PNG({ width: picture.width, height: picture.height });
  png.data = Buffer.from(picture.data);
  await writeFile(path.join(FOLDER, `on-the-photo-${name}.png`), PNG.sync.write(png));
}
