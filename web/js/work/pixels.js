/**
 * The pixels of a picture, RGBA row by row, with a bitmap laid into it; what it leaves free is transparent.
 *
 * @param {ImageBitmap} bitmap is closed
 * @param {number} width px
 * @param {number} height px
 * @param {{ left: number, top: number }} [place] of the bitmap in the picture, px
 */
export function pixelsOf(bitmap, width, height, place = { left: 0, top: 0 }) {
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no 2D canvas");
  context.drawImage(bitmap, place.left, place.top);
  bitmap.close();
  return new Uint8Array(context.getImageData(0, 0, width, height).data.buffer);
}
