/** @typedef {import("../../wasm/rosto-vision-web.js").RawPicture} RawPicture */

/** Visually lossless. */
const JPEG_QUALITY = 0.95;

/**
 * Encodes a picture, without metadata.
 *
 * @param {RawPicture} picture
 * @param {import("./protocol.js").PhotoType} type
 */
export function encoded(picture, type) {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context?.putImageData(imageDataOf(picture), 0, 0);
  // A JPEG has no transparency.
  if (context && type === "image/jpeg") fillBelow(context, "white");
  return canvas.convertToBlob({ type, quality: JPEG_QUALITY });
}

/**
 * Converts a picture without changing its pixels.
 *
 * @param {RawPicture} picture
 */
export function bitmapOf(picture) {
  return createImageBitmap(imageDataOf(picture), { premultiplyAlpha: "none", colorSpaceConversion: "none" });
}

/** @param {RawPicture} picture */
function imageDataOf({ rgba, width, height }) {
  return new ImageData(/** @type {Uint8ClampedArray<ArrayBuffer>} */ (rgba), width, height);
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
