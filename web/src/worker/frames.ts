import type { FollowedFrame } from "./protocol.ts";
import type { Vision } from "../../wasm/rosto-vision-web.js";

/** Runs the networks on successive frames of a camera stream. */

/** Larger frames are scaled down: the landmark network reads a face in 192 px, and averaging pixels reduces jitter. */
const LONGEST_SIDE_PX = 640;

/** Reused: creating a canvas costs more than reading a frame. */
const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true });

/**
 * Finds the followed face in the next frame.
 *
 * @param time_ms timestamp
 */
export function follow(vision: Vision, frame: ImageBitmap, time_ms: number): FollowedFrame {
  const start_ms = performance.now();
  const { data, width, height } = readPixels(frame);
  const read_ms = performance.now() - start_ms;
  const landmarks = vision.follow(new Uint8Array(data.buffer), width, height, time_ms);
  const took_ms = { read: read_ms, landmarks: performance.now() - start_ms - read_ms };
  return { time_ms, landmarks, width_px: frame.width, height_px: frame.height, took_ms, frame };
}

/**
 * Reads the pixels of a frame, scaled down to `LONGEST_SIDE_PX`.
 *
 * Landmark coordinates start at the centre of the first pixel. Scaling moves this centre, so the copy is shifted by the
 * same amount, and the landmarks fit the original frame.
 */
function readPixels(frame: ImageBitmap) {
  if (!context) throw new Error("no 2D canvas");
  const scale = Math.min(1, LONGEST_SIDE_PX / Math.max(frame.width, frame.height));
  const [width, height] = [frame.width, frame.height].map((side) => Math.max(1, Math.round(side * scale)));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const shift = (1 - scale) / 2;
  context.drawImage(frame, shift, shift, width, height);
  return context.getImageData(0, 0, width, height);
}
