import { checkSize } from "../../wasm/rosto-vision-web.js";

/**
 * A photo as the browser decodes it, which may know more formats than the module does: an upright PNG in sRGB. Nothing if
 * the browser cannot decode it either.
 *
 * @param {Blob} photo
 */
export async function decodedByBrowser(photo) {
  const bitmap = await createImageBitmap(photo).catch(() => undefined);
  if (!bitmap) return undefined;
  const { width, height } = bitmap;
  try {
    checkSize(width, height);
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d", { colorSpace: "srgb" })?.drawImage(bitmap, 0, 0);
    return await canvas.convertToBlob({ type: "image/png" }).catch(() => undefined);
  } finally {
    bitmap.close();
  }
}
