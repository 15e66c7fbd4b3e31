/** Minimum duration of a sample; browsers coarsen their clocks. */
const SAMPLE_MS = 4;
/** Yield to the page after this long. */
const SLICE_MS = 10;
const SAMPLES = 3;
const MAX_REPETITIONS = 4096;

/** Times short work in slices, and yields to the page between them. */
export class Stopwatch {
  /** Repetitions in the last sample; the next sample starts with the same number. */
  #times = 1;

  /**
   * Median duration of one repetition, in ms.
   *
   * @param work repeats the work `times` times
   */
  async time(work: (times: number) => void) {
    const samples_ms = [];
    while (samples_ms.length < SAMPLES) {
      const started_ms = performance.now();
      work(this.#times);
      const took_ms = performance.now() - started_ms;
      if (took_ms < SAMPLE_MS && this.#times < MAX_REPETITIONS) this.#times *= 2;
      else samples_ms.push(took_ms / this.#times);
      if (took_ms > SLICE_MS && this.#times > 1) this.#times /= 2;
      await nextTask();
    }
    return samples_ms.sort((one, other) => one - other)[SAMPLES >> 1] ?? 0;
  }
}

function nextTask() {
  return new Promise<void>((resolve) => setTimeout(resolve));
}
