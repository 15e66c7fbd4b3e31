import { bitmapOf } from "../work/pixels.ts";
import type { Host,  } from "../viewport/host.ts";
import type { Studio } from "../../wasm/rosto-studio-web.js";

/** Scale relative to the canvas, as for a single picture; limited because two pictures must fit into one canvas. */
const SCALE = 2;
const MAX_PX = 2048;

/**
 * Pictures of the face before and after the edits, with the same camera. Both are requested in one task, which restores
 * the view at its end, so the screen does not change.
 *
 * @param isTransparent transparent background
 */
export async function beforeAndAfter(host: Host, isTransparent: boolean) {
  const size = sizeOf(host.canvas);
  const requests = [1, 0].map((before) => host.picture((studio) => snapshot(studio, before, size, isTransparent)));
  const [before, after] = await Promise.all(requests.map(async (picture) => bitmapOf(await picture)));
  if (!before || !after) throw new Error("invariant: two pictures were requested");
  return { before, after };
}

/** Size of the canvas, cropped to a square if it is wider than high: the sides show only background. */
function sizeOf({ width, height }: HTMLCanvasElement): [number, number] {
  const scale = Math.min(SCALE, MAX_PX / height);
  return [Math.round(scale * Math.min(width, height)), Math.round(scale * height)];
}

function snapshot(studio: Studio, before: number, size_px: [number, number], isTransparent: boolean) {
  studio.apply({ before });
  try {
    return studio.snapshot(...size_px, isTransparent);
  } finally {
    studio.apply({ before: 0 });
  }
}
