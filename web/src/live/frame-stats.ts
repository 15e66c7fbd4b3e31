import type { FollowedFrame } from "../worker/protocol.ts";

/** A shown frame; `page_ms`: time spent on the page; `age`: number of newer frames. */
export type Sample = Omit<FollowedFrame, "frame"> & { at_ms: number; page_ms: number; age: number };

export type Figures = NonNullable<ReturnType<typeof figuresOf>>;

/**
 * Speed and steadiness of the live preview: means over frames, the maximum age, and the jitter of the landmarks, which
 * is NaN until three frames had a face. Undefined before two frames.
 */
export function figuresOf(samples: Sample[]) {
  const [first, last] = [samples.at(0), samples.at(-1)];
  if (!first || !last || first === last) return undefined;
  const interval_ms = (last.at_ms - first.at_ms) / (samples.length - 1);
  const variances = samples.slice(2).flatMap((sample, at) => jitterVariance(samples[at], samples[at + 1], sample));
  return {
    frames: 1000 / interval_ms,
    interval_ms,
    worker_ms: mean(samples.map(({ took_ms }) => took_ms.read + took_ms.landmarks)),
    page_ms: mean(samples.map(({ page_ms }) => page_ms)),
    age: Math.max(...samples.map(({ age }) => age)),
    jitter_px: Math.sqrt(mean(variances)),
  };
}

/**
 * Variance of the landmarks' jitter in px, estimated from three frames; empty if one has no face. The distance of the
 * middle position from the mean of the other two removes uniform motion; for independent noise, its mean square is 1.5
 * times the variance.
 */
function jitterVariance(...samples: Sample[]) {
  const [before, middle, after] = samples.map(({ landmarks }) => landmarks);
  if (!before || !middle || !after) return [];
  const sides_px = [samples[0].width_px, samples[0].height_px, 0];
  const squares = middle.map((place, at) => (sides_px[at % 3] * (place - (before[at] + after[at]) / 2)) ** 2);
  return [(3 * mean(squares)) / 1.5];
}

function mean(numbers: number[] | Float32Array) {
  let sum = 0;
  for (const each of numbers) sum += each;
  return sum / numbers.length;
}
