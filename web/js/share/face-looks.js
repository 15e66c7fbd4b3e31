import { bitmapOf } from "../work/pixels.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").Studio} Studio
 */

/** A picture is twice the size of the screen, like the one that is saved alone, but two of them must fit into a canvas. */
const SCREENS = 2;
const MOST_PX = 2048;

/**
 * The face as it was found and as it is now, seen by the same camera. Nothing of it shows on the screen: both are asked for
 * in one task, at whose end the view is as it was.
 *
 * @param {Host} host
 * @param {boolean} isTransparent where there is no face
 */
export async function faceLooks(host, isTransparent) {
  const size = sizeOf(host.canvas);
  const asked = [1, 0].map((before) => host.picture((studio) => lookAt(studio, before, size, isTransparent)));
  const [before, after] = await Promise.all(asked.map(async (picture) => bitmapOf(await picture)));
  if (!before || !after) throw new Error("invariant: two were asked for");
  return { before, after };
}

/**
 * As high as the screen's, and no wider than high: beside a face there is only ground.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {[number, number]}
 */
function sizeOf({ width, height }) {
  const scale = Math.min(SCREENS, MOST_PX / height);
  return [Math.round(scale * Math.min(width, height)), Math.round(scale * height)];
}

/**
 * @param {Studio} studio
 * @param {number} before
 * @param {[number, number]} size_px
 * @param {boolean} isTransparent
 */
function lookAt(studio, before, size_px, isTransparent) {
  studio.setBefore(before);
  try {
    return studio.snapshot(...size_px, isTransparent);
  } finally {
    studio.setBefore(0);
  }
}
