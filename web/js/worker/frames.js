/**
 * Frames of a film, one after the other, through the networks.
 *
 * @typedef {import("./protocol.js").Followed} Followed
 * @typedef {import("../../wasm/rosto-vision-web.js").Vision} Vision
 */

/** Larger frames are read smaller: the landmark network sees a face in 192 px, and the mean of several pixels trembles less. */
const LONGEST_SIDE_PX = 640;

/** Kept from frame to frame: a new one each time would cost more than reading it. */
const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });

/**
 * Where the face that is followed is in the next frame.
 *
 * @param {Vision} vision
 * @param {ImageBitmap} frame
 * @param {number} time_ms when it was taken
 * @returns {Followed}
 */
export function follow(vision, frame, time_ms) {
  const begun = performance.now();
  const { data, width, height } = read(frame);
  const read_ms = performance.now() - begun;
  const landmarks = vision.follow(new Uint8Array(data.buffer), width, height, time_ms);
  const took_ms = { read: read_ms, landmarks: performance.now() - begun - read_ms };
  return { time_ms, landmarks, width_px: frame.width, height_px: frame.height, took_ms, frame };
}

/**
 * The pixels of a frame, or of a smaller copy of it.
 *
 * Landmarks count from the middle of the first pixel, which lies further in the larger the pixels are: the copy is moved by
 * as much, so that they are those of the frame itself.
 *
 * @param {ImageBitmap} frame
 */
function read(frame) {
  if (!context) throw new Error("no 2D canvas");
  const scale = Math.min(1, LONGEST_SIDE_PX / Math.max(frame.width, frame.height));
  const [width, height] = [frame.width, frame.height].map((side) => Math.max(1, Math.round(side * scale)));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const shift = (1 - scale) / 2;
  context.drawImage(frame, shift, shift, width, height);
  return context.getImageData(0, 0, width, height);
}
