/** Larger pictures are refused; the module's own limit is the same. */
const MAX_PIXELS = 50_000_000;

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
    if (width * height > MAX_PIXELS) {
      throw { code: "too-many-pixels", message: `${width} × ${height} px; the limit is ${MAX_PIXELS} pixels`, hint: "" };
    }
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d", { colorSpace: "srgb" })?.drawImage(bitmap, 0, 0);
    return await canvas.convertToBlob({ type: "image/png" }).catch(() => undefined);
  } finally {
    bitmap.close();
  }
}
