/**
 * A photo with what was edited in it, as a file.
 *
 * @typedef {import("./protocol.js").Edited} Edited
 */
import { Warped } from "../../wasm/rosto-vision-web.js";
import { asPageError } from "../page/page-error.js";
import { bytesOf } from "../work/bytes.js";
import { decodedByBrowser } from "./browser-decoder.js";

/** Visually without loss. */
const JPEG_QUALITY = 0.95;

/**
 * The photo at its full size, upright and in sRGB. Of what its file told besides, such as where it was taken, nothing is left.
 *
 * @param {Edited} edited
 * @returns {Promise<Blob>}
 */
export async function drawEdited(edited) {
  const { width, height, pixels } = await drawnDecoded(edited);
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context?.putImageData(new ImageData(pixels, width, height), 0, 0);
  // A JPEG has no transparency: what is below is white.
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

/** @param {Edited} edited whose photo the browser decodes where the module does not read its format */
async function drawnDecoded(edited) {
  try {
    return drawn(await bytesOf(edited.photo), edited);
  } catch (error) {
    const decoded = asPageError(error).code === "unsupported-format" ? await decodedByBrowser(edited.photo) : undefined;
    if (!decoded) throw error;
    return drawn(await bytesOf(decoded), edited);
  }
}

/**
 * @param {Uint8Array} bytes
 * @param {Edited} edited
 */
function drawn(bytes, { width_px, from_px, to_px, triangles }) {
  const warped = new Warped(bytes, width_px, from_px, to_px, triangles);
  try {
    const pixels = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (warped.pixels().buffer));
    return { width: warped.width, height: warped.height, pixels };
  } finally {
    warped.free();
  }
}
