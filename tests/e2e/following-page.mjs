// Runs in the page: drives a VisionClient for the tests of face tracking.
import { numberOf } from "./video-frames.mjs";

/**
 * An answered camera frame; `answersMeanwhile`: answers to other frames since it was sent.
 *
 * @typedef {{ number: number, landmarks_px: number[][] | undefined, answersMeanwhile: number }} Seen
 */

/** A loaded VisionClient of the module `parts`. */
export async function client() {
  const client = new globalThis.parts.VisionClient();
  client.start();
  await client.ready;
  return client;
}

/** Tracks the camera for a while; sends each frame as soon as it arrives. @param {number} duration_ms */
export async function watch(duration_ms) {
  const vision = await client();
  const video = document.createElement("video");
  video.srcObject = await navigator.mediaDevices.getUserMedia({ video: { width: 640, height: 480 } });
  await video.play();
  /** @type {Seen[]} */
  const seen = [];
  const asked = [];
  const until = performance.now() + duration_ms;
  while (performance.now() < until) {
    const time_ms = await new Promise((resolve) => video.requestVideoFrameCallback((_, { mediaTime }) => resolve(1000 * mediaTime)));
    const before = seen.length;
    asked.push(
      vision.follow(await createImageBitmap(video), time_ms).then((followed) => {
        if (followed) seen.push({ ...whatIsOn(followed), answersMeanwhile: seen.length - before });
      }),
    );
  }
  await Promise.all(asked);
  vision.stopFollowing();
  return seen;
}

const canvas = new OffscreenCanvas(1, 1);
const context = canvas.getContext("2d", { willReadFrequently: true });

/** @param {import("../../web/src/worker/protocol.ts").FollowedFrame} followed */
function whatIsOn({ frame, landmarks, width_px, height_px }) {
  Object.assign(canvas, { width: width_px, height: height_px });
  context.drawImage(frame, 0, 0);
  frame.close();
  const number = numberOf(context.getImageData(0, 0, width_px, height_px));
  const points = landmarks && Array.from({ length: landmarks.length / 3 }, (_, point) => point);
  return { number, landmarks_px: points?.map((at) => [landmarks[3 * at] * width_px, landmarks[3 * at + 1] * height_px]) };
}
