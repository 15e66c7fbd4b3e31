import { afterNextFrame } from "../page/tasks.js";
import { imageDataOf } from "../work/pixels.js";
import { Recorder } from "./recorder.js";
import { Swing } from "./swing.js";

/** @typedef {import("../viewport/workbench.js").Workbench} Workbench */

const SWING_MS = 3400;
/** At its end the face is still for a moment, and for some pictures: some of them may be dropped. */
const LENGTH_MS = 4000;
const LAST_PICTURES = 5;
/** A browser is behind with what it records, and drops what it has not come to. */
const BEHIND_MS = 600;
/** A square fits on every screen; codecs want even sides. */
const SIDE_PX = 720;

/**
 * @typedef {object} Wishes
 * @property {string} type MIME
 * @property {AbortSignal} signal ends it; its reason is thrown
 * @property {() => boolean} isSameFace
 * @property {(share: number) => void} told how much is recorded, 0 to 1
 */

/**
 * Records the face as it swings once from side to side. Each frame is a picture of its own, drawn without the tools that
 * the screen goes on showing. In the end the view is as it was, however that comes about.
 *
 * @param {Workbench} bench
 * @param {Wishes} wishes
 */
export async function recordClip(bench, wishes) {
  const recorder = new Recorder(wishes.type, SIDE_PX);
  const swing = new Swing(bench);
  const stopped = whenAborted(wishes.signal);
  try {
    await Promise.race([stopped, film(bench, swing, recorder, wishes)]);
    return await Promise.race([stopped, recorder.finish()]);
  } finally {
    recorder.stop();
    swing.end(wishes.isSameFace());
  }
}

/**
 * @param {Workbench} bench
 * @param {Swing} swing
 * @param {Recorder} recorder
 * @param {Wishes} wishes
 */
async function film(bench, swing, recorder, { signal, isSameFace, told }) {
  const { studio } = bench;
  // A studio that was started again shows the face from the front, and is another one.
  const check = () => {
    if (bench.studio !== studio || !isSameFace()) throw new Error("another face has come");
  };
  const start_ms = performance.now();
  let still = 0;
  for (let past_ms = 0; past_ms < LENGTH_MS || still < LAST_PICTURES; past_ms = performance.now() - start_ms) {
    swing.go(Math.min(1, past_ms / SWING_MS));
    if (past_ms >= SWING_MS) still += 1;
    await afterNextFrame();
    check();
    const picture = await pictureOf(studio);
    if (signal.aborted) return;
    check();
    recorder.show(picture);
    told(past_ms / LENGTH_MS);
  }
  await new Promise((resolve) => setTimeout(resolve, BEHIND_MS));
}

/** @param {import("../viewport/workbench.js").Studio} studio */
async function pictureOf(studio) {
  const snapshot = await studio.snapshot(SIDE_PX, SIDE_PX, false);
  const size = { pictureWidth_px: snapshot.width, pictureHeight_px: snapshot.height };
  const picture = snapshot.takePixels();
  snapshot.free();
  return imageDataOf({ picture, ...size });
}

/**
 * @param {AbortSignal} signal
 * @returns {Promise<never>}
 */
function whenAborted(signal) {
  const aborted = new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason), { once: true }));
  aborted.catch(() => {});
  return /** @type {Promise<never>} */ (aborted);
}
