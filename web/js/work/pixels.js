/** @typedef {{ picture: Uint8Array, pictureWidth_px: number, pictureHeight_px: number }} Picture RGBA, row by row */

/**
 * RGBA pixels of a picture with a bitmap drawn into it; the rest is transparent. Closes the bitmap.
 *
 * @param {ImageBitmap} bitmap
 * @param {number} width px
 * @param {number} height px
 * @param {ArrayLike<number>} [place] of the bitmap in the picture, px: left, top, width, height
 */
export function pixelsOf(bitmap, width, height, { 0: left = 0, 1: top = 0, 2: placeWidth = width, 3: placeHeight = height } = []) {
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no 2D canvas");
  context.imageSmoothingQuality = "high";
  context.drawImage(bitmap, left, top, placeWidth, placeHeight);
  bitmap.close();
  return new Uint8Array(context.getImageData(0, 0, width, height).data.buffer);
}

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
