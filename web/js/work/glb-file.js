import { studioModule } from "../viewport/studio-module.js";
import { pixelsOf } from "./pixels.js";

/**
 * @typedef {import("./work.js").Work} Work
 * @typedef {import("../../wasm/rosto-studio-web.js").ReopenedFace} ReopenedFace
 */

/**
 * Whether a file begins as a binary glTF file does.
 *
 * @param {Blob} file
 */
export async function isGlbFile(file) {
  return (await file.slice(0, 4).text()) === "glTF";
}

/**
 * The work out of a GLB that was downloaded here. The page's module must have been started.
 *
 * @param {Blob} file
 * @returns {Promise<Work>}
 */
export async function readGlbFile(file) {
  const opened = studioModule().reopenGlb(new Uint8Array(await file.arrayBuffer()));
  try {
    const { width: width_px, height: height_px, edits, triangulation, density } = opened;
    const size = { pictureWidth_px: opened.pictureWidth, pictureHeight_px: opened.pictureHeight };
    const face = { width_px, height_px, landmarks: opened.landmarks(), colours: opened.colours() };
    return { face: { ...face, ...size, picture: await pictureOf(opened) }, edits, triangulation, density };
  } finally {
    opened.free();
  }
}

/** @param {ReopenedFace} opened */
async function pictureOf(opened) {
  const painted = opened.takePainted();
  if (painted) return painted;
  const jpeg = new Blob([/** @type {BlobPart} */ (opened.takeJpeg())], { type: "image/jpeg" });
  const bitmap = await decoded(jpeg);
  return pixelsOf(bitmap, opened.pictureWidth, opened.pictureHeight, { left: opened.cropLeft, top: opened.cropTop });
}

/** @param {Blob} jpeg */
async function decoded(jpeg) {
  try {
    return await createImageBitmap(jpeg);
  } catch (error) {
    throw { code: "damaged-glb", message: String(error), hint: "" };
  }
}
