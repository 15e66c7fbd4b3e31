/**
 * @typedef {object} Sample one displayed frame
 * @property {number} at_ms time of display
 * @property {number} worker_ms time spent in the worker
 * @property {number} page_ms time spent on the page
 * @property {number} age number of newer camera frames at that time
 * @property {number[] | undefined} places_px x and y of each landmark in turn
 *
 * @typedef {object} Figures
 * @property {number} frames frames per second
 * @property {number} interval_ms
 * @property {number} worker_ms
 * @property {number} page_ms
 * @property {number} age maximum
 * @property {number} jitter_px NaN until three frames had a face
 */

const WINDOW_MS = 1000;

/** Speed and steadiness of the live preview: mean over the last second. */
export class FrameStats {
  /** @type {(Sample & { jitter_px2: number })[]} */
  #samples = [];

  /** @param {Sample} sample */
  add(sample) {
    const [before, last] = this.#samples.slice(-2);
    const jitter_px2 = jitterVariance(before?.places_px, last?.places_px, sample.places_px);
    this.#samples.push({ ...sample, jitter_px2 });
    this.#samples = this.#samples.filter(({ at_ms }) => sample.at_ms - at_ms <= WINDOW_MS);
  }

  /** Undefined before two frames. @returns {Figures | undefined} */
  read() {
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
 *
 * @param {number[] | undefined} before
 * @param {number[] | undefined} last
 * @param {number[] | undefined} now
 */
function jitterVariance(before, last, now) {
  if (!before || !last || !now) return NaN;
  let sum = 0;
  for (let at = 0; at < now.length; at += 1) {
    const off = (last[at] ?? 0) - ((before[at] ?? 0) + (now[at] ?? 0)) / 2;
    sum += off * off;
  }
  return sum / (now.length / 2) / 1.5;
}

/** @param {number[]} numbers */
function mean(numbers) {
  return numbers.reduce((sum, each) => sum + each, 0) / numbers.length;
}
