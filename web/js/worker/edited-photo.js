/**
 * Draws the edited photo as a file.
 *
 * @typedef {import("./protocol.js").PhotoEdit} PhotoEdit
 */
import { Warped } from "../../wasm/rosto-vision-web.js";
import { asPageError } from "../page/page-error.js";
import { bytesOf } from "../work/bytes.js";
import { decodeWithBrowser } from "./browser-decoder.js";

/** Visually lossless. */
const JPEG_QUALITY = 0.95;

/**
 * Draws the photo at full size, upright and in sRGB, without metadata such as its location.
 *
 * @param {PhotoEdit} edited
 * @returns {Promise<Blob>}
 */
export async function drawEdited(edited) {
  const { width, height, pixels } = await decodeAndWarp(edited);
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context?.putImageData(new ImageData(pixels, width, height), 0, 0);
  // A JPEG has no transparency.
  if (context && edited.format === "image/jpeg") fillBelow(context, "white");
  return canvas.convertToBlob({ type: edited.format, quality: JPEG_QUALITY });
}

/**
 * @param {OffscreenCanvasRenderingContext2D} context
 * @param {string} colour
 */
function fillBelow(context, colour) {
  context.globalCompositeOperation = "destination-over";
  context.fillStyle = colour;
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
}

/** Falls back to the browser's decoder for formats that the module does not read. @param {PhotoEdit} edited */
async function decodeAndWarp(edited) {
  try {
    return warp(await bytesOf(edited.photo), edited);
  } catch (error) {
    const decoded = asPageError(error).code === "unsupported-format" ? await decodeWithBrowser(edited.photo) : undefined;
    if (!decoded) throw error;
    return warp(await bytesOf(decoded), edited);
  }
}

/**
 * @param {Uint8Array} bytes
 * @param {PhotoEdit} edited
 */
function warp(bytes, { width_px, from_px, to_px, triangles }) {
  const warped = new Warped(bytes, width_px, from_px, to_px, triangles);
  try {
    const pixels = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (warped.pixels().buffer));
    return { width: warped.width, height: warped.height, pixels };
  } finally {
    warped.free();
  }
}
