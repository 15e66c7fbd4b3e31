import { afterNextFrame } from "../page/tasks.js";
import { imageDataOf } from "../work/pixels.js";
import { Recorder } from "./recorder.js";
import { Swing } from "./swing.js";

/** @typedef {import("../viewport/host.js").Host} Host */

const SWING_MS = 3400;
/** Fewer pictures make the swing jerky: a slow machine draws this many before the recording starts. */
const LEAST_PICTURES = 8;
/** Share of the progress bar for drawing them. */
const AHEAD_SHARE = 0.8;
/** The clip ends on a still face, shown a few times at long intervals: each picture delays a slow encoder. */
const LENGTH_MS = 4000;
const LAST_PICTURES = 5;
const LAST_PICTURE_MS = 150;
/** Time for the encoder to catch up: what it has not encoded when the recording stops is lost. */
const BEHIND_MS = 1500;
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
 * @param {Host} host
 * @param {Wishes} wishes
 */
export async function recordClip(host, wishes) {
  const recorder = new Recorder(wishes.type, SIDE_PX);
  const swing = new Swing(host);
  const stopped = whenAborted(wishes.signal);
  try {
    await Promise.race([stopped, film(host, swing, recorder, wishes)]);
    return await Promise.race([stopped, recorder.finish()]);
  } finally {
    recorder.stop();
    swing.end(wishes.isSameFace());
  }
}

/**
 * @param {Host} host
 * @param {Swing} swing
 * @param {Recorder} recorder
 * @param {Wishes} wishes
 */
async function film(host, swing, recorder, { signal, isSameFace, told }) {
  const { instance } = host;
  // A studio that was started again shows the face from the front, and is another one.
  const check = () => {
    signal.throwIfAborted();
    if (host.instance !== instance || !isSameFace()) throw new Error("another face has come");
  };
  const draw = async (/** @type {number} */ share) => {
    swing.go(share);
    await afterNextFrame();
    check();
    const picture = imageDataOf(await host.picture((studio) => studio.snapshot(SIDE_PX, SIDE_PX, false)));
    check();
    return picture;
  };
  // What draws a picture may have to be made first.
  await draw(0);
  // Of the face as it was, from which the swing goes out and to which it comes back.
  const asked_ms = performance.now();
  const still = await draw(0);
  let drawing_ms = performance.now() - asked_ms;
  const ahead = drawing_ms > SWING_MS / LEAST_PICTURES ? await drawAhead(draw, told) : [];
  const before = ahead.length > 0 ? AHEAD_SHARE : 0;
  const start_ms = performance.now();
  const past_ms = () => performance.now() - start_ms;
  const show = (/** @type {ImageData} */ picture) => {
    recorder.show(picture);
    told(before + (1 - before) * (past_ms() / LENGTH_MS));
  };
  show(still);
  for (const [place, picture] of ahead.entries()) {
    await wait(((place + 1) * SWING_MS) / LEAST_PICTURES - past_ms());
    check();
    show(picture);
  }
  // A picture is seen once it is drawn: it shows the face as it will have turned by then, at the earliest.
  while (past_ms() + drawing_ms < SWING_MS) {
    const begun_ms = past_ms();
    show(await draw((begun_ms + drawing_ms) / SWING_MS));
    drawing_ms = Math.min(drawing_ms, past_ms() - begun_ms);
  }
  swing.go(1);
  for (let shown = 0; past_ms() < LENGTH_MS || shown < LAST_PICTURES; shown += 1) {
    show(still);
    await wait(LAST_PICTURE_MS);
    check();
  }
  await wait(BEHIND_MS);
}

/**
 * Draws the swing before it is recorded.
 *
 * @param {(share: number) => Promise<ImageData>} draw
 * @param {(share: number) => void} told
 */
async function drawAhead(draw, told) {
  const pictures = [];
  for (let turn = 1; turn < LEAST_PICTURES; turn += 1) {
    pictures.push(await draw(turn / LEAST_PICTURES));
    told((AHEAD_SHARE * turn) / LEAST_PICTURES);
  }
  return pictures;
}

/** @param {number} duration_ms */
function wait(duration_ms) {
  return new Promise((resolve) => setTimeout(resolve, duration_ms));
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
