import { pngOf } from "../work/pixels.js";

const TYPE = "image/png";

/** So many pixels of the picture for each of the screen's, along a side. */
const SCREENS = 2;

/**
 * The view as it is, larger than on the screen, as PNG.
 *
 * @param {import("../viewport/host.js").Host} host
 * @param {boolean} isTransparent where there is no face
 */
export async function viewPicture(host, isTransparent) {
  const { width, height } = host.canvas;
  return pngOf(await host.picture((studio) => studio.snapshot(SCREENS * width, SCREENS * height, isTransparent)));
}

/** Whether this browser copies pictures. */
export function canCopyPictures() {
  if (typeof ClipboardItem !== "function" || !navigator.clipboard?.write) return false;
  return ClipboardItem.supports?.(TYPE) ?? true;
}

/**
 * Puts a picture on the clipboard. It may be still on its way: Safari wants to be asked while the button is pressed.
 *
 * @param {Promise<Blob>} coming
 */
export async function copyPicture(coming) {
  try {
    await navigator.clipboard.write([new ClipboardItem({ [TYPE]: coming })]);
  } catch (error) {
    // What went wrong with the picture itself is told as such.
    await coming;
    throw { code: "not-copied", message: String(error), hint: "" };
  }
}
