/** What is timed lasts at least this long, so that the clock, which browsers make coarse, can tell. */
const SAMPLE_MS = 4;
/** The page has something else to do after this long. */
const SLICE_MS = 10;
const SAMPLES = 3;
const MOST_TIMES = 4096;

/** Times short work in slices, between which the page goes on. */
export class Stopwatch {
  /** How often the work was repeated for the last sample; the next one begins with as many. */
  #times = 1;

  /**
   * The median of what `work` takes each time, in ms.
   *
   * @param {(times: number) => void} work does the same so many times
   */
  async time(work) {
    const samples_ms = [];
    while (samples_ms.length < SAMPLES) {
      const started_ms = performance.now();
      work(this.#times);
      const took_ms = performance.now() - started_ms;
      if (took_ms < SAMPLE_MS && this.#times < MOST_TIMES) this.#times *= 2;
      else samples_ms.push(took_ms / this.#times);
      if (took_ms > SLICE_MS && this.#times > 1) this.#times /= 2;
      await nextTask();
    }
    return samples_ms.sort((one, other) => one - other)[SAMPLES >> 1] ?? 0;
  }
}

function nextTask() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => setTimeout(resolve));
}
