import { scriptUrl } from "../trusted.ts";
import type { Outcome } from "../../wasm/rosto-studio-web.js";

/** The number of issues of each severity. */
type Verdict = Exclude<Outcome, string>["validated"];

/** Maximum wait before the page counts as loaded without the validator. */
const START_TIMEOUT_MS = 60_000;

/** After this time, a file is saved unchecked. */
const TIMEOUT_MS = 5000;

/** Runs Khronos' glTF validator in a worker. */
export class Validator {
  #worker: Worker | undefined;
  #pending: Map<number, (verdict: Verdict | undefined) => void> = new Map();
  #lastId = 0;

  /** Starts the worker. Resolves when it is ready or has failed. */
  start() {
    return new Promise<void>((resolve) => {
      setTimeout(resolve, START_TIMEOUT_MS);
      const worker = new Worker(scriptUrl(new URL("./validator-worker.js", import.meta.url)));
      worker.addEventListener("message", ({ data }) => {
        if (data.ready) {
          this.#worker = worker;
          resolve();
        } else {
          this.#settle(data.id, data.verdict);
        }
      });
      worker.addEventListener("error", (event) => {
        event.preventDefault();
        this.#worker = undefined;
        resolve();
      });
    });
  }

  /** Validates a GLB; undefined if the validator is not available. */
  check(bytes: Uint8Array): Promise<Verdict | undefined> {
    if (!this.#worker) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    return new Promise((resolve) => {
      this.#pending.set(id, resolve);
      setTimeout(() => this.#settle(id, undefined), TIMEOUT_MS);
      this.#worker?.postMessage({ id, bytes });
    });
  }

  #settle(id: number, verdict: Verdict | undefined) {
    this.#pending.get(id)?.(verdict);
    this.#pending.delete(id);
  }
}
