/**
 * @typedef {object} Picture
 * @property {number} width
 * @property {number} height
 * @property {Uint8ClampedArray<ArrayBuffer>} rgba row by row, straight alpha
 */

/** Visually lossless. */
const JPEG_QUALITY = 0.95;

/**
 * Encodes a picture, without metadata.
 *
 * @param {Picture} picture
 * @param {"image/png" | "image/jpeg"} type
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
 * @param {Picture} picture
 */
export function bitmapOf(picture) {
  return createImageBitmap(imageDataOf(picture), { premultiplyAlpha: "none", colorSpaceConversion: "none" });
}

/** @param {Picture} picture */
export function imageDataOf({ rgba, width, height }) {
  return new ImageData(rgba, width, height);
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
