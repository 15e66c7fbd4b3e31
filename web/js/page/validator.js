import { ownScript } from "./trusted.js";

/** @typedef {import("../worker/protocol.js").Verdict} Verdict */

/** The page counts as loaded without it after this long; it may still come. */
const START_PATIENCE_MS = 60_000;

/** A file is handed over unchecked rather than later than this. */
const PATIENCE_MS = 5000;

/** Khronos' glTF validator, in a worker of its own. */
export class Validator {
  /** @type {Worker | undefined} */
  #worker;
  /** @type {Map<number, (verdict: Verdict | undefined) => void>} */
  #waiting = new Map();
  #lastId = 0;

  /** Starts it. Resolves when it is there, or when it is clear that it will not be. */
  start() {
    return new Promise((/** @type {(value: void) => void} */ resolve) => {
      setTimeout(resolve, START_PATIENCE_MS);
      const worker = new Worker(ownScript("js/worker/validator-worker.js"));
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
   * What it says of a GLB; nothing where it cannot say.
   *
   * @param {Uint8Array} bytes
   * @returns {Promise<Verdict | undefined>}
   */
  check(bytes) {
    if (!this.#worker) return Promise.resolve(undefined);
    const id = ++this.#lastId;
    return new Promise((resolve) => {
      this.#waiting.set(id, resolve);
      setTimeout(() => this.#settle(id, undefined), PATIENCE_MS);
      this.#worker?.postMessage({ id, bytes });
    });
  }

  /**
   * @param {number} id
   * @param {Verdict | undefined} verdict
   */
  #settle(id, verdict) {
    this.#waiting.get(id)?.(verdict);
    this.#waiting.delete(id);
  }
}
