import { pixelsOf } from "./pixels.js";

/**
 * The project file: one line of JSON, then the landmarks (f32, little-endian), the colours, and the picture as PNG.
 *
 * @typedef {import("./work.js").Work} Work
 */

const FORMAT = "rosto-project";
const VERSION = 1;
const LANDMARKS = 468;
const LANDMARK_BYTES = LANDMARKS * 3 * Float32Array.BYTES_PER_ELEMENT;
const COLOUR_BYTES = LANDMARKS * 3;

/**
 * The work as a file.
 *
 * @param {Work} work
 */
export async function projectFile({ face, edits, triangulation, density }) {
  const { width_px, height_px } = face;
  const header = { format: FORMAT, version: VERSION, width_px, height_px, triangulation, density, edits: JSON.parse(edits) };
  const parts = [`${JSON.stringify(header)}\n`, face.landmarks, face.colours, await pngOf(face)];
  return new Blob(/** @type {BlobPart[]} */ (parts), { type: "application/octet-stream" });
}

/**
 * Whether a file begins as a project does.
 *
 * @param {Blob} file
 */
export async function isProjectFile(file) {
  const start = await file.slice(0, 64).text();
  return start.startsWith(`{"format":"${FORMAT}"`);
}

/**
 * The work out of a project file.
 *
 * @param {Blob} file
 * @returns {Promise<Work>}
 */
export async function readProjectFile(file) {
  try {
    return await read(file);
  } catch (error) {
    throw { code: "bad-project", message: String(error), hint: "" };
  }
}

/**
 * @param {Blob} file
 * @returns {Promise<Work>}
 */
async function read(file) {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const body = bytes.indexOf("\n".charCodeAt(0)) + 1;
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(0, body)));
  const { version, width_px, height_px, triangulation, density, edits } = header;
  if (version !== VERSION) throw new Error(`version ${version}; this page reads ${VERSION}`);
  const coloursAt = body + LANDMARK_BYTES;
  const pictureAt = coloursAt + COLOUR_BYTES;
  const landmarks = new Float32Array(bytes.slice(body, coloursAt).buffer);
  const picture = await rgbaOf(new Blob([bytes.slice(pictureAt)], { type: "image/png" }));
  const face = { width_px, height_px, landmarks, colours: bytes.slice(coloursAt, pictureAt), ...picture };
  return { face, edits: JSON.stringify(edits), triangulation, density };
}

/** @param {import("./work.js").OpenedFace} face */
async function pngOf({ picture, pictureWidth_px, pictureHeight_px }) {
  const canvas = new OffscreenCanvas(pictureWidth_px, pictureHeight_px);
  const pixels = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (picture.buffer));
  canvas.getContext("2d")?.putImageData(new ImageData(pixels, pictureWidth_px, pictureHeight_px), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/** @param {Blob} png */
async function rgbaOf(png) {
  const bitmap = await createImageBitmap(png);
  const { width: pictureWidth_px, height: pictureHeight_px } = bitmap;
  return { pictureWidth_px, pictureHeight_px, picture: pixelsOf(bitmap, pictureWidth_px, pictureHeight_px) };
}
