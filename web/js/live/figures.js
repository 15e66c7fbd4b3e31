/**
 * @typedef {object} Shown a frame that was brought to the stage
 * @property {number} at_ms when
 * @property {number} worker_ms what the worker spent on it
 * @property {number} page_ms what the page spent on it
 * @property {number} age how many frames of the camera were newer by then
 * @property {number[] | undefined} places_px of its landmarks, x and y in turn
 *
 * @typedef {object} Figures of the last second
 * @property {number} frames a second
 * @property {number} interval_ms
 * @property {number} worker_ms
 * @property {number} page_ms
 * @property {number} age the greatest
 * @property {number} jitter_px not a number before three frames had a face
 */

const KEPT_MS = 1000;

/** How quick and how steady the mirror is: the mean of the last second. */
export class Stopwatch {
  /** @type {(Shown & { trembling_px2: number })[]} */
  #shown = [];

  /** @param {Shown} shown */
  take(shown) {
    const [before, last] = this.#shown.slice(-2);
    const trembling_px2 = trembling(before?.places_px, last?.places_px, shown.places_px);
    this.#shown.push({ ...shown, trembling_px2 });
    this.#shown = this.#shown.filter(({ at_ms }) => shown.at_ms - at_ms <= KEPT_MS);
  }

  /** Nothing before two frames. @returns {Figures | undefined} */
  read() {
    const [first, ...others] = this.#shown;
    const last = others.at(-1);
    if (!first || !last) return undefined;
    const interval_ms = (last.at_ms - first.at_ms) / others.length;
    const jitters = this.#shown.map(({ trembling_px2 }) => trembling_px2).filter((each) => !Number.isNaN(each));
    return {
      frames: 1000 / interval_ms,
      interval_ms,
      worker_ms: mean(this.#shown.map(({ worker_ms }) => worker_ms)),
      page_ms: mean(this.#shown.map(({ page_ms }) => page_ms)),
      age: Math.max(...this.#shown.map(({ age }) => age)),
      jitter_px: Math.sqrt(mean(jitters)),
    };
  }

  clear() {
    this.#shown = [];
  }
}

/**
 * Mean square of what is left of three frames when all motion at one speed is taken out: of the middle one's distance from the
 * mean of the other two. Where each trembles by itself that is 1.5 times what one of them does.
 *
 * @param {number[] | undefined} before
 * @param {number[] | undefined} last
 * @param {number[] | undefined} now
 */
function trembling(before, last, now) {
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
