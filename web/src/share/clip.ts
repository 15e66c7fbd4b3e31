import { afterNextFrame } from "../page/tasks.ts";
import { imageDataOf } from "../work/pixels.ts";
import { Recorder } from "./recorder.ts";
import { Swing } from "./swing.ts";
import type { Host } from "../viewport/host.ts";

const SWING_MS = 3400;
/** Fewer frames make the swing jerky, so a slow machine draws this many before the recording starts. */
const MIN_FRAMES = 8;
/** Fraction of the progress bar for drawing them. */
const PRERENDER_FRACTION = 0.8;
/** The clip ends on a still face, with few frames at long intervals, as each frame delays a slow encoder. */
const LENGTH_MS = 4000;
const STILL_FRAMES = 5;
const STILL_FRAME_MS = 150;
/** Time for the encoder to catch up: frames not encoded when the recording stops are lost. */
const ENCODER_LAG_MS = 1500;
/** Codecs need even sides. */
const SIDE_PX = 720;

export interface ClipOptions {
  /** MIME */
  type: string;
  /** cancels the recording; its reason is thrown */
  signal: AbortSignal;
  isSameFace: () => boolean;
  /** 0 to 1 */
  onProgress: (fraction: number) => void;
}

/**
 * Records the face swinging once from side to side. Each frame is drawn off screen, without the editing tools. Restores
 * the view at the end, also after an error.
 */
export async function recordClip(host: Host, options: ClipOptions) {
  const recorder = new Recorder(options.type, SIDE_PX);
  const swing = new Swing(host);
  const aborted = whenAborted(options.signal);
  try {
    await Promise.race([aborted, record(host, swing, recorder, options)]);
    return await Promise.race([aborted, recorder.finish()]);
  } finally {
    recorder.stop();
    swing.end(options.isSameFace());
  }
}

async function record(host: Host, swing: Swing, recorder: Recorder, { signal, isSameFace, onProgress }: ClipOptions) {
  const { instance } = host;
  // A restarted studio has reset the view.
  const check = () => {
    signal.throwIfAborted();
    if (host.instance !== instance || !isSameFace()) throw new Error("the face changed during the recording");
  };
  const draw = async (phase: number) => {
    swing.setPhase(phase);
    await afterNextFrame();
    check();
    const picture = imageDataOf(await host.picture((studio) => studio.snapshot(SIDE_PX, SIDE_PX, false)));
    check();
    return picture;
  };
  // Warm-up: the first draw may create GPU resources.
  await draw(0);
  // The start and end of the swing.
  const still_ms = performance.now();
  const still = await draw(0);
  let drawing_ms = performance.now() - still_ms;
  const prerendered = drawing_ms > SWING_MS / MIN_FRAMES ? await prerender(draw, onProgress) : [];
  const done = prerendered.length > 0 ? PRERENDER_FRACTION : 0;
  const start_ms = performance.now();
  const elapsed_ms = () => performance.now() - start_ms;
  const show = (picture: ImageData) => {
    recorder.show(picture);
    onProgress(done + (1 - done) * (elapsed_ms() / LENGTH_MS));
  };
  show(still);
  for (const [index, picture] of prerendered.entries()) {
    await wait(((index + 1) * SWING_MS) / MIN_FRAMES - elapsed_ms());
    check();
    show(picture);
  }
  // Draw each frame for the time at which it will be ready, by the shortest drawing time so far.
  while (elapsed_ms() + drawing_ms < SWING_MS) {
    const begin_ms = elapsed_ms();
    show(await draw((begin_ms + drawing_ms) / SWING_MS));
    drawing_ms = Math.min(drawing_ms, elapsed_ms() - begin_ms);
  }
  swing.setPhase(1);
  for (let shown = 0; elapsed_ms() < LENGTH_MS || shown < STILL_FRAMES; shown += 1) {
    show(still);
    await wait(STILL_FRAME_MS);
    check();
  }
  await wait(ENCODER_LAG_MS);
}

/** Draws the frames of the swing before the recording starts. */
async function prerender(draw: (phase: number) => Promise<ImageData>, onProgress: (fraction: number) => void) {
  const frames = [];
  for (let index = 1; index < MIN_FRAMES; index += 1) {
    frames.push(await draw(index / MIN_FRAMES));
    onProgress((PRERENDER_FRACTION * index) / MIN_FRAMES);
  }
  return frames;
}

function wait(duration_ms: number) {
  return new Promise((resolve) => setTimeout(resolve, duration_ms));
}

function whenAborted(signal: AbortSignal): Promise<never> {
  const aborted = new Promise((_, reject) => signal.addEventListener("abort", () => reject(signal.reason), { once: true }));
  aborted.catch(() => {});
  return (aborted as Promise<never>);
}
