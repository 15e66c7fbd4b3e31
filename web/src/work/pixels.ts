export interface Picture {
  width: number;
  height: number;
  rgba: Uint8ClampedArray<ArrayBuffer>;
}

/** Visually lossless. */
const JPEG_QUALITY = 0.95;

/** Encodes a picture, without metadata. */
export function encoded(picture: Picture, type: "image/png" | "image/jpeg") {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  const context = canvas.getContext("2d", { willReadFrequently: true });
  context?.putImageData(imageDataOf(picture), 0, 0);
  // A JPEG has no transparency.
  if (context && type === "image/jpeg") {
    context.globalCompositeOperation = "destination-over";
    context.fillStyle = "white";
    context.fillRect(0, 0, picture.width, picture.height);
  }
  return canvas.convertToBlob({ type, quality: JPEG_QUALITY });
}

/** Converts a picture without changing its pixels. */
export function bitmapOf(picture: Picture) {
  return createImageBitmap(imageDataOf(picture), { premultiplyAlpha: "none", colorSpaceConversion: "none" });
}

export function imageDataOf({ rgba, width, height }: Picture) {
  return new ImageData(rgba, width, height);
}
