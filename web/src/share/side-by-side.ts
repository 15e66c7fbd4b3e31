type Picture = ImageBitmap | HTMLCanvasElement;
type Captions = { before: string; after: string; };

/** Gap between the pictures, relative to their height. */
const GAP = 0.008;
/** Font size of the captions, relative to the pictures' height. */
const FONT_SIZE = 0.022;

/** Readable on any picture, also on a transparent one shown on a white page. */
const CAPTION_COLOURS = { background: "rgb(0 0 0 / .62)", text: "#fff" };

/** Combines two pictures of the same size into one PNG, with captions and a transparent gap. */
export function sideBySide(before: Picture, after: Picture, captions: Captions): Promise<Blob> {
  const { width, height } = before;
  const left_px = width + Math.max(2, Math.round(GAP * height));
  const canvas = new OffscreenCanvas(left_px + width, height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("no 2D canvas");
  context.drawImage(before, 0, 0);
  context.drawImage(after, left_px, 0, width, height);
  drawCaption(context, captions.before, width / 2, height);
  drawCaption(context, captions.after, left_px + width / 2, height);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * Draws a caption at the lower edge.
 *
 * @param height_px of the picture
 */
function drawCaption(context: OffscreenCanvasRenderingContext2D, text: string, centre_px: number, height_px: number) {
  const font_px = Math.max(11, FONT_SIZE * height_px);
  context.font = `${font_px}px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif`;
  const [width, height] = [context.measureText(text).width + 1.6 * font_px, 1.8 * font_px];
  const top_px = height_px - 2.8 * font_px;
  context.fillStyle = CAPTION_COLOURS.background;
  context.beginPath();
  context.roundRect(centre_px - width / 2, top_px, width, height, height / 2);
  context.fill();
  context.fillStyle = CAPTION_COLOURS.text;
  context.textAlign = "center";
  // The baseline is half a capital's height below the centre.
  context.fillText(text, centre_px, top_px + height / 2 + 0.36 * font_px);
}
