import { checkSize } from "../../wasm/rosto-vision-web.js";

/**
 * Decodes a photo with the browser, which may support more formats than the module. Returns an upright sRGB PNG, or
 * undefined if the browser cannot decode the photo.
 */
export async function decodeWithBrowser(photo: Blob) {
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
