/**
 * @typedef {import("../worker/protocol.js").Request} Request
 * @typedef {import("../worker/protocol.js").Reply} Reply
 * @typedef {import("../worker/protocol.js").Stage} Stage
 * @typedef {import("../worker/protocol.js").FoundFaces} FoundFaces
 * @typedef {{ resolve: (found: FoundFaces) => void, reject: (error: unknown) => void, report: (stage: Stage, fraction: number) => void }} Waiting
 */

/** A worker silent for this long while a photo waits is taken for dead; one that loads tells of every part that arrives. */
const SILENCE_MS = 60_000;

/** Larger photos are refused unread; the worker's own limit is the same. */
const MAX_PHOTO_BYTES = 40_000_000;

/** Thrown to whoever waits for a photo that a newer one has replaced. */
export class Replaced extends Error {}

/** The page's side of the worker: starts it, asks it, and starts it again when it dies. */
export class VisionClient {
  /** @type {Worker | undefined} */
  #worker;
  /** @type {Map<number, Waiting>} */
  #waiting = new Map();
  #lastId = 0;
  #silence = 0;
  #starts = 0;
  #isReady = false;
  /** Resolves once the worker has loaded, or once it is clear that it will not. @type {Promise<void>} */
  ready;
  /** @type {() => void} */
  #nowReady = () => {};

  constructor() {
    this.ready = this.#untilReady();
  }

  /** How often a worker has been started. */
  get starts() {
    return this.#starts;
  }

  /** Starts the worker unless one is there. */
  start() {
    if (this.#worker) return;
    this.#starts += 1;
    this.#isReady = false;
    const worker = new Worker(new URL("../worker/vision-worker.js", import.meta.url), { type: "module" });
    worker.addEventListener("message", (event) => this.#hear(worker, event.data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.#bury(worker, { code: "not-loaded", message: event.message ?? "", hint: "" });
    });
    this.#worker = worker;
  }

  /**
   * Finds the faces of a photo. A newer photo replaces an older one, whose promise is then rejected with `Replaced`.
   *
   * @param {Blob} photo
   * @param {number} maxFaces
   * @param {(stage: Stage, fraction: number) => void} report
   * @returns {Promise<FoundFaces>}
   */
  async find(photo, maxFaces, report) {
    this.#rejectAll(new Replaced());
    if (photo.size > MAX_PHOTO_BYTES) {
      throw { code: "too-many-bytes", message: `${photo.size} bytes; the limit is ${MAX_PHOTO_BYTES}`, hint: "" };
    }
    this.start();
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, report });
      this.#post({ type: "find", id, photo, maxFaces });
      this.#watchSilence();
    });
  }

  /** @param {Request} request */
  #post(request) {
    this.#worker?.postMessage(request);
  }

  /**
   * @param {Worker} worker
   * @param {Reply} reply
   */
  #hear(worker, reply) {
    if (worker !== this.#worker) return;
    this.#watchSilence();
    switch (reply.type) {
      case "alive":
        return this.#noticeDeath(worker, reply.lock);
      case "loading":
        return;
      case "ready":
        this.#isReady = true;
        return this.#nowReady();
      case "unusable":
        return this.#bury(worker, reply.error);
      case "progress":
        return this.#waiting.get(reply.id)?.report(reply.stage, reply.fraction);
      case "found":
        return this.#settle(reply.id)?.resolve(reply.found);
      case "failed":
        return this.#settle(reply.id)?.reject(reply.error);
      case "trapped":
        return this.#replace(worker, reply.message);
    }
  }

  /**
   * The worker holds this lock while it lives; being granted it means that the worker is gone.
   *
   * @param {Worker} worker
   * @param {string} lock
   */
  async #noticeDeath(worker, lock) {
    await navigator.locks.request(lock, () => {});
    if (worker !== this.#worker) return;
    // One that dies before it has loaded would die again: the next photo tries once more.
    if (this.#isReady) this.#replace(worker, "the worker ended");
    else this.#bury(worker, { code: "worker-died", message: "the worker ended while loading", hint: "" });
  }

  /**
   * @param {Worker} worker
   * @param {string} message
   */
  #replace(worker, message) {
    this.#bury(worker, { code: "worker-died", message, hint: "" });
    this.ready = this.#untilReady();
    this.start();
  }

  /**
   * @param {Worker} worker
   * @param {import("../worker/protocol.js").PageError} error
   */
  #bury(worker, error) {
    worker.terminate();
    if (worker === this.#worker) this.#worker = undefined;
    this.#nowReady();
    this.#rejectAll(error);
  }

  /** @param {number} id */
  #settle(id) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (this.#waiting.size === 0) clearTimeout(this.#silence);
    return waiting;
  }

  /** @param {unknown} error */
  #rejectAll(error) {
    for (const id of [...this.#waiting.keys()]) this.#settle(id)?.reject(error);
  }

  #watchSilence() {
    clearTimeout(this.#silence);
    if (this.#waiting.size === 0) return;
    this.#silence = setTimeout(() => this.#endSilence(), SILENCE_MS);
  }

  /** A worker that never came is not started again by itself: the next photo does that. */
  #endSilence() {
    const message = `silent for ${SILENCE_MS / 1000} s`;
    if (!this.#worker) return;
    if (this.#isReady) this.#replace(this.#worker, message);
    else this.#bury(this.#worker, { code: "not-loaded", message, hint: "" });
  }

  #untilReady() {
    return new Promise((/** @type {(value: void) => void} */ resolve) => {
      this.#nowReady = resolve;
    });
  }
}
