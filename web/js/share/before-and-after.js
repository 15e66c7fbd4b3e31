import { bitmapOf } from "../work/pixels.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").Studio} Studio
 */

/** Scale relative to the canvas, as for a single picture; limited because two pictures must fit into one canvas. */
const SCALE = 2;
const MAX_PX = 2048;

/**
 * Pictures of the face before and after the edits, with the same camera. Both are requested in one task, which restores
 * the view at its end, so the screen does not change.
 *
 * @param {Host} host
 * @param {boolean} isTransparent transparent background
 */
export async function beforeAndAfter(host, isTransparent) {
  const size = sizeOf(host.canvas);
  const requests = [1, 0].map((before) => host.picture((studio) => snapshot(studio, before, size, isTransparent)));
  const [before, after] = await Promise.all(requests.map(async (picture) => bitmapOf(await picture)));
  if (!before || !after) throw new Error("invariant: two pictures were requested");
  return { before, after };
}

/**
 * Size of the canvas, cropped to a square if it is wider than high: the sides show only background.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {[number, number]}
 */
function sizeOf({ width, height }) {
  const scale = Math.min(SCALE, MAX_PX / height);
  return [Math.round(scale * Math.min(width, height)), Math.round(scale * height)];
}

/**
 * @param {Studio} studio
 * @param {number} before
 * @param {[number, number]} size_px
 * @param {boolean} isTransparent
 */
function snapshot(studio, before, size_px, isTransparent) {
  studio.apply({ before });
  try {
    return studio.snapshot(...size_px, isTransparent);
  } finally {
    studio.apply({ before: 0 });
  }
}
