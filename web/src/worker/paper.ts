import type { PaperRun } from "../../wasm/rosto-vision-web.js";

/** Minimum duration of a sample; browsers coarsen their clocks. */
const SAMPLE_MS = 4;
/** The worker answers other requests after this long. */
const SLICE_MS = 10;
const SAMPLES = 3;
const MAX_REPETITIONS = 4096;

/** Runs the paper's experiment, and times each step, while `goesOn` returns true. */
export async function runPaper(run: PaperRun, report: (share: number) => void, goesOn: () => boolean) {
  /** Repetitions in the last sample; the next step starts with as many. */
  let times = 1;
  while (run.share < 1) {
    const samples_ms = [];
    while (samples_ms.length < SAMPLES) {
      const start_ms = performance.now();
      run.repeat(times);
      const took_ms = performance.now() - start_ms;
      if (took_ms < SAMPLE_MS && times < MAX_REPETITIONS) times *= 2;
      else samples_ms.push(took_ms / times);
      if (took_ms > SLICE_MS && times > 1) times /= 2;
      await new Promise((resolve) => setTimeout(resolve));
      if (!goesOn()) return undefined;
    }
    run.goOn(samples_ms.sort((one, other) => one - other)[SAMPLES >> 1] ?? 0);
    report(run.share);
  }
  return run.results();
}
