/** @typedef {ImageBitmap | HTMLCanvasElement} Look a picture of the face */
/** @typedef {{ before: string, after: string }} Captions */

/** Between the two, as a share of a picture's height. */
const GAP = 0.008;
/** Of the captions' letters; the rest of a caption goes by it. */
const LETTER = 0.022;

/** On whatever lies below them, also where that is transparent and the page that shows it is white. */
const LABEL_COLOURS = { ground: "rgb(0 0 0 / .62)", letters: "#fff" };

/**
 * Two pictures of one size beside each other as a PNG, each with its caption. The gap between them is transparent.
 *
 * @param {Look} before
 * @param {Look} after
 * @param {Captions} captions
 * @returns {Promise<Blob>}
 */
export function sideBySide(before, after, captions) {
  const { width, height } = before;
  const left_px = width + Math.max(2, Math.round(GAP * height));
  const canvas = new OffscreenCanvas(left_px + width, height);
  const context = canvas.getContext("2d");
  if (!context) throw new Error("no 2D canvas");
  context.drawImage(before, 0, 0);
  context.drawImage(after, left_px, 0, width, height);
  label(context, captions.before, width / 2, height);
  label(context, captions.after, left_px + width / 2, height);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * Writes a caption at the lower edge.
 *
 * @param {OffscreenCanvasRenderingContext2D} context
 * @param {string} words
 * @param {number} middle_px
 * @param {number} height_px of the picture
 */
function label(context, words, middle_px, height_px) {
  const letter_px = Math.max(11, LETTER * height_px);
  context.font = `${letter_px}px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", sans-serif`;
  const [width, height] = [context.measureText(words).width + 1.6 * letter_px, 1.8 * letter_px];
  const top_px = height_px - 2.8 * letter_px;
  context.fillStyle = LABEL_COLOURS.ground;
  context.beginPath();
  context.roundRect(middle_px - width / 2, top_px, width, height, height / 2);
  context.fill();
  context.fillStyle = LABEL_COLOURS.letters;
  context.textAlign = "center";
  // Half of a capital's height below the middle.
  context.fillText(words, middle_px, top_px + height / 2 + 0.36 * letter_px);
}
