import { encoded } from "../work/pixels.ts";
import type { Host } from "../viewport/host.ts";

const TYPE = "image/png";

/** Resolution relative to the canvas. */
const SCALE = 2;

/**
 * The current view as PNG, at twice the resolution of the canvas.
 *
 * @param isTransparent transparent background
 */
export async function viewPicture(host: Host, isTransparent: boolean) {
  const { width, height } = host.canvas;
  return encoded(await host.picture((studio) => studio.snapshot(SCALE * width, SCALE * height, isTransparent)), TYPE);
}

/** Whether this browser can copy pictures to the clipboard. */
export function canCopyPictures() {
  if (typeof ClipboardItem !== "function" || !navigator.clipboard?.write) return false;
  return ClipboardItem.supports?.(TYPE) ?? true;
}

/** Copies a picture to the clipboard. Takes a promise, because Safari requires the call during the click. */
export async function copyPicture(picture: Promise<Blob>) {
  try {
    await navigator.clipboard.write([new ClipboardItem({ [TYPE]: picture })]);
  } catch (error) {
    // Rethrows the picture's own error, if there is one.
    await picture;
    throw { code: "not-copied", message: String(error), hint: "" };
  }
}
