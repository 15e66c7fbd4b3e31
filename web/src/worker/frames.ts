/** Larger frames are scaled down: the landmark network reads a face in 192 px, and averaging pixels reduces jitter. */
const LONGEST_SIDE_PX = 640;

/** Reused: creating a canvas costs more than reading a frame. */
const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });

/**
 * Reads the pixels of a camera frame, scaled down to `LONGEST_SIDE_PX`.
 *
 * Landmark coordinates start at the centre of the first pixel. Scaling moves this centre, so the copy is shifted by the
 * same amount, and the landmarks fit the original frame.
 */
export function readPixels(frame: ImageBitmap) {
  if (!context) throw new Error("no 2D canvas");
  const scale = Math.min(1, LONGEST_SIDE_PX / Math.max(frame.width, frame.height));
  const [width, height] = [frame.width, frame.height].map((side) => Math.max(1, Math.round(side * scale)));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const shift = (1 - scale) / 2;
  context.drawImage(frame, shift, shift, width, height);
  return context.getImageData(0, 0, width, height);
}
