import { scriptUrl } from "../../src/trusted.ts";

/** @typedef {import("../../src/verdict.ts").Verdict} Verdict */

/** Maximum wait before the page counts as loaded without the validator. */
const START_TIMEOUT_MS = 60_000;

/** After this time, a file is saved unchecked. */
const TIMEOUT_MS = 5000;

/** Runs Khronos' glTF validator in a worker. */
export class Validator {
  /** @type {Worker | undefined} */
  #worker;
  /** @type {Map<number, (verdict: Verdict | undefined) => void>} */
  #pending = new Map();
  #lastId = 0;

  /** Starts the worker. Resolves when it is ready or has failed. */
  start() {
    return new Promise((/** @type {(value: void) => void} */ resolve) => {
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

  /**
   * Validates a GLB; undefined if the validator is not available.
   *
   * @param {Uint8Array} bytes
   * @returns {Promise<Verdict | undefined>}
   */
  check(bytes) {
    if (!this.#worker) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    return new Promise((resolve) => {
      this.#pending.set(id, resolve);
      setTimeout(() => this.#settle(id, undefined), TIMEOUT_MS);
      this.#worker?.postMessage({ id, bytes });
    });
  }

  /**
   * @param {number} id
   * @param {Verdict | undefined} verdict
   */
  #settle(id, verdict) {
    this.#pending.get(id)?.(verdict);
    this.#pending.delete(id);
  }
}
