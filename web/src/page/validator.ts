import { scriptUrl } from "../trusted.ts";
import type { Outcome } from "../../wasm/rosto-studio-web.js";

/** The number of issues of each severity. */
type Verdict = Exclude<Outcome, string>["validated"];

/** Maximum wait before the page counts as loaded without the validator. */
const START_TIMEOUT_MS = 60_000;

/** After this time, a file is saved unchecked. */
const TIMEOUT_MS = 5000;

/** Undefined until it has started, and after a failure. */
let worker: Worker | undefined;

/** Starts Khronos' glTF validator in a worker. Resolves when it is ready or has failed. */
export function startValidator() {
  return new Promise<void>((resolve) => {
    setTimeout(resolve, START_TIMEOUT_MS);
    const starting = new Worker(scriptUrl(new URL("./validator-worker.js", import.meta.url)));
    const settle = (started: Worker | undefined) => {
      worker = started;
      resolve();
    };
    starting.addEventListener("message", () => settle(starting), { once: true });
    starting.addEventListener("error", (event) => {
      event.preventDefault();
      settle(undefined);
    });
  });
}

/** Validates a GLB; undefined if the validator is not available. */
export function validate(bytes: Uint8Array) {
  return new Promise<Verdict | undefined>((resolve) => {
    if (!worker) return resolve(undefined);
    const id = crypto.randomUUID();
    const signal = AbortSignal.timeout(TIMEOUT_MS);
    signal.addEventListener("abort", () => resolve(undefined));
    worker.addEventListener("message", ({ data }) => data.id === id && resolve(data.verdict), { signal });
    worker.postMessage({ id, bytes });
  });
}
