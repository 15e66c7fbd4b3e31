interface Sample {
  at_ms: number;
  worker_ms: number;
  page_ms: number;
  age: number;
  places_px: number[] | undefined;
}

export interface Figures {
  /** frames per second */
  frames: number;
  interval_ms: number;
  /** time spent in the worker */
  worker_ms: number;
  /** time spent on the page */
  page_ms: number;
  /** maximum */
  age: number;
  /** NaN until three frames had a face */
  jitter_px: number;
}

const WINDOW_MS = 1000;

/** Speed and steadiness of the live preview: mean over the last second. */
export class FrameStats {
  #samples: (Sample & { jitter_px2: number; })[] = [];

  add(sample: Sample) {
    const [before, last] = this.#samples.slice(-2);
    const jitter_px2 = jitterVariance(before?.places_px, last?.places_px, sample.places_px);
    this.#samples.push({ ...sample, jitter_px2 });
    this.#samples = this.#samples.filter(({ at_ms }) => sample.at_ms - at_ms <= WINDOW_MS);
  }

  /** Undefined before two frames. */
  read(): Figures | undefined {
    const [first, ...others] = this.#samples;
    const last = others.at(-1);
    if (!first || !last) return undefined;
    const interval_ms = (last.at_ms - first.at_ms) / others.length;
    const jitters = this.#samples.map(({ jitter_px2 }) => jitter_px2).filter((each) => !Number.isNaN(each));
    return {
      frames: 1000 / interval_ms,
      interval_ms,
      worker_ms: mean(this.#samples.map(({ worker_ms }) => worker_ms)),
      page_ms: mean(this.#samples.map(({ page_ms }) => page_ms)),
      age: Math.max(...this.#samples.map(({ age }) => age)),
      jitter_px: Math.sqrt(mean(jitters)),
    };
  }

  clear() {
    this.#samples = [];
  }
}

/**
 * Variance of the landmarks' jitter, estimated from three frames. The distance of the middle position from the mean of
 * the other two removes uniform motion; for independent noise, its mean square is 1.5 times the variance.
 */
function jitterVariance(before: number[] | undefined, last: number[] | undefined, now: number[] | undefined) {
  if (!before || !last || !now) return NaN;
  let sum = 0;
  for (let at = 0; at < now.length; at += 1) {
    const off = (last[at] ?? 0) - ((before[at] ?? 0) + (now[at] ?? 0)) / 2;
    sum += off * off;
  }
  return sum / (now.length / 2) / 1.5;
}

function mean(numbers: number[]) {
  return numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
}
