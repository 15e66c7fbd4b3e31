/** @typedef {{ picture: Uint8Array, pictureWidth_px: number, pictureHeight_px: number }} Picture RGBA, row by row */

/** @param {Picture} picture */
export function bitmapOf(picture) {
  return createImageBitmap(imageDataOf(picture));
}

/** @param {Picture} picture */
export function pngOf(picture) {
  const canvas = new OffscreenCanvas(picture.pictureWidth_px, picture.pictureHeight_px);
  canvas.getContext("2d")?.putImageData(imageDataOf(picture), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * Wraps a picture's bytes without copying them.
 *
 * @param {Picture} picture
 */
export function imageDataOf({ picture, pictureWidth_px, pictureHeight_px }) {
  const pixels = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (picture.buffer));
  return new ImageData(pixels, pictureWidth_px, pictureHeight_px);
}
