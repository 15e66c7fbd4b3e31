/** Pictures of the view. They load when one is made, so this file shares no code with the page. */

import { encoded, imageDataOf } from "../work/pixels.ts";
import type { Host } from "../viewport/host.ts";

/** Resolution relative to the canvas. */
const SCALE = 2;
/** Height limit of a pair, which has to fit into one canvas. */
const MAX_PX = 2048;

/** Gap between two pictures, and font size of their captions, relative to their height. */
const GAP = 0.008;
const FONT_SIZE = 0.022;
const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif';
/** Readable on any picture, also on a transparent one shown on a white page. */
const [TEXT, BEHIND_TEXT] = ["#fff", "rgb(0 0 0 / .62)"];

/** The current view as PNG. */
export async function drawView(host: Host) {
  const { width, height } = host.canvas;
  const picture = await host.picture((studio) => studio.snapshot(SCALE * width, SCALE * height, studio.isTransparent));
  return encoded(picture, "image/png");
}

/**
 * The face before and after the edits, side by side as PNG. The sides of a wide view, which show only background, are
 * cut off.
 *
 * @param captions of the two pictures
 */
export async function drawPair(host: Host, captions: string[]) {
  const scale = Math.min(SCALE, MAX_PX / host.canvas.height);
  const height = Math.round(scale * host.canvas.height);
  const width = Math.min(height, Math.round(scale * host.canvas.width));
  // Both are requested in one task, which restores the view at its end, so the screen does not change.
  const pictures = await Promise.all([1, 0].map((before) => drawAt(host, before, width, height)));
  const left_px = width + Math.max(2, Math.round(GAP * height));
  const canvas = new OffscreenCanvas(left_px + width, height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("no 2D canvas");
  for (const [index, picture] of pictures.entries()) {
    context.putImageData(imageDataOf(picture), index * left_px, 0);
    drawCaption(context, captions[index] ?? "", index * left_px + width / 2);
  }
  return canvas.convertToBlob({ type: "image/png" });
}

function drawAt(host: Host, before: number, width: number, height: number) {
  return host.picture((studio) => {
    studio.apply({ before });
    try {
      return studio.snapshot(width, height, studio.isTransparent);
    } finally {
      studio.apply({ before: 0 });
    }
  });
}

/** Draws a caption at the lower edge. */
function drawCaption(context: OffscreenCanvasRenderingContext2D, text: string, centre_px: number) {
  const height_px = context.canvas.height;
  const font_px = Math.max(11, FONT_SIZE * height_px);
  context.font = `${font_px}px ${FONT}`;
  const [width, height] = [context.measureText(text).width + 1.6 * font_px, 1.8 * font_px];
  const top_px = height_px - 2.8 * font_px;
  context.fillStyle = BEHIND_TEXT;
  context.beginPath();
  context.roundRect(centre_px - width / 2, top_px, width, height, height / 2);
  context.fill();
  context.fillStyle = TEXT;
  context.textAlign = "center";
  // The baseline is half a capital's height below the centre.
  context.fillText(text, centre_px, top_px + height / 2 + 0.36 * font_px);
}
