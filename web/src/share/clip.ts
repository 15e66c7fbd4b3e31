/** Recording of a clip. It loads when one is recorded, so this file shares no code with the page. */

import type { Host } from "../viewport/host.ts";

const SWING_MS = 3400;
/** Far enough to show the profile, without exposing the open back of the face. In radians. */
const AMPLITUDE = (35 * Math.PI) / 180;
/** Fewer frames make the swing jerky, so a slow machine draws this many before the recording starts. */
const MIN_FRAMES = 8;
const SLOW_FRAME_MS = SWING_MS / MIN_FRAMES;
/** Fraction of the progress bar for drawing them. */
const PRERENDER_FRACTION = 0.8;
/** The clip ends on a still face, with few frames at long intervals, as each frame delays a slow encoder. */
const STILL_FRAMES = 5;
const STILL_FRAME_MS = 150;
/** Time for the encoder to catch up: frames not encoded when the recording stops are lost. */
const ENCODER_LAG_MS = 1500;

/** Codecs need even sides. */
const SIDE_PX = 720;
const FRAMES_PER_S = 30;
const BITS_PER_S = 6_000_000;
/** In order of preference; Safari supports only the last. */
const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

interface Options {
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
export async function recordClip(host: Host, { signal, isSameFace, onProgress }: Options) {
  const { recorder, show } = openRecorder();
  const { instance } = host;
  const isAutoRotating = host.read(({ turntable }) => turntable);
  if (isAutoRotating) host.apply({ turntable: false });
  // A restarted studio and another face have a new view.
  const isSame = () => host.instance === instance && isSameFace();
  const check = () => {
    signal.throwIfAborted();
    if (!isSame()) throw new Error("the face changed during the recording");
  };
  let shown = 0;
  const rotateTo = (angle: number) => {
    // A drag over the canvas' current height rotates by 180°.
    host.apply({ orbit: [((angle - shown) * host.canvas.height) / Math.PI, 0] });
    shown = angle;
  };
  const draw = async (phase: number) => {
    rotateTo(-AMPLITUDE * Math.sin(2 * Math.PI * phase));
    await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    check();
    const { rgba } = await host.picture((studio) => studio.snapshot(SIDE_PX, SIDE_PX, false));
    check();
    return new ImageData(rgba, SIDE_PX, SIDE_PX);
  };
  const wait = async (duration_ms: number) => {
    await new Promise((resolve) => setTimeout(resolve, duration_ms));
    check();
  };
  /** Shows the swing in real time. */
  const play = async () => {
    // Warm-up: the first draw may create GPU resources.
    await draw(0);
    const before_ms = performance.now();
    const still = await draw(0);
    let frame_ms = performance.now() - before_ms;
    let frameAt = draw;
    let done = 0;
    if (frame_ms > SLOW_FRAME_MS) {
      const frames = [still];
      while (frames.length < MIN_FRAMES) {
        frames.push(await draw(frames.length / MIN_FRAMES));
        done = (PRERENDER_FRACTION * frames.length) / MIN_FRAMES;
        onProgress(done);
      }
      frame_ms = SLOW_FRAME_MS;
      frameAt = (phase) => wait(SLOW_FRAME_MS).then(() => frames[Math.round(phase * MIN_FRAMES)] ?? still);
    }
    const start_ms = performance.now();
    const elapsed_ms = () => performance.now() - start_ms;
    show(still);
    // Draws each frame for the time at which it will be ready, by the shortest drawing time so far.
    while (elapsed_ms() + frame_ms < SWING_MS) {
      const begin_ms = elapsed_ms();
      show(await frameAt((begin_ms + frame_ms) / SWING_MS));
      frame_ms = Math.min(frame_ms, elapsed_ms() - begin_ms);
      onProgress(done + (1 - done) * (elapsed_ms() / SWING_MS));
    }
    await wait(SWING_MS - elapsed_ms());
    for (let frame = 0; frame < STILL_FRAMES; frame += 1) {
      show(still);
      await wait(STILL_FRAME_MS);
    }
    await wait(ENCODER_LAG_MS);
  };
  const clip = new Promise<Blob>((resolve, reject) => {
    recorder.addEventListener("dataavailable", ({ data }) => resolve(data));
    recorder.addEventListener("error", reject);
    signal.addEventListener("abort", () => reject(signal.reason));
  });
  try {
    await Promise.race([clip, play()]);
    recorder.stop();
    const data = await clip;
    return new Blob([data], { type: data.type.replace(/;.*/, "") });
  } finally {
    for (const track of recorder.stream.getTracks()) track.stop();
    if (isSame()) rotateTo(0);
    if (isAutoRotating && host.instance === instance) host.apply({ turntable: true });
  }
}

/** Records pictures in real time, from the first one on. */
function openRecorder() {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [SIDE_PX, SIDE_PX];
  const context = canvas.getContext("2d", { alpha: false });
  const mimeType = TYPES.find((type) => MediaRecorder.isTypeSupported(type)) ?? "";
  const recorder = new MediaRecorder(canvas.captureStream(FRAMES_PER_S), { mimeType, videoBitsPerSecond: BITS_PER_S });
  const show = (picture: ImageData) => {
    context?.putImageData(picture, 0, 0);
    if (recorder.state === "inactive") recorder.start();
  };
  return { recorder, show };
}
