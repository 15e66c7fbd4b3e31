import { filesBase } from "../files.js";
import { listHash } from "../page/built.js";
import { ownScript } from "../page/trusted.js";
import { Following } from "./following.js";

/**
 * @typedef {import("../worker/protocol.js").Request} Request
 * @typedef {import("../worker/protocol.js").Reply} Reply
 * @typedef {import("../worker/protocol.js").Stage} Stage
 * @typedef {import("../worker/protocol.js").FoundFaces} FoundFaces
 * @typedef {import("../worker/protocol.js").Followed} Followed
 * @typedef {import("../worker/protocol.js").Edited} Edited
 * @typedef {import("../worker/protocol.js").Untextured} Untextured
 * @typedef {{ resolve: (answer: any) => void, reject: (error: unknown) => void, died: string }} Asking who waits, and the code of what did not come about if the worker dies
 * @typedef {{ resolve: (found: FoundFaces) => void, reject: (error: unknown) => void, report: (stage: Stage, fraction: number) => void }} Waiting
 */

/** A worker silent for this long while somebody waits is taken for dead; one that loads tells of every part that arrives. */
const SILENCE_MS = 60_000;

/** A group photo offers this many faces at most. */
const MAX_FACES = 20;

/** Thrown to whoever waits for a photo that a newer one has replaced. */
export class Replaced extends Error {}

/** The page's side of the worker: starts it, asks it, and starts it again when it dies. */
export class VisionClient {
  /** @type {Worker | undefined} */
  #worker;
  /** @type {Map<number, Waiting>} */
  #waiting = new Map();
  /** Who waits for something else than faces. @type {Map<number, Asking>} */
  #asking = new Map();
  #lastId = 0;
  #silence = 0;
  #starts = 0;
  #isReady = false;
  #following = new Following((request, transfer) => this.#post(request, transfer));
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
    const worker = workerOfThisPage();
    worker.addEventListener("message", (event) => this.#onMessage(worker, event.data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.#terminate(worker, { code: "not-loaded", message: event.message ?? "", hint: "" });
    });
    this.#worker = worker;
    this.#post({ type: "load", base: filesBase(), list: listHash() });
  }

  /** Ends the worker and gives its memory back; whoever still waits hears so. The next photo starts another. */
  end() {
    if (this.#worker) this.#terminate(this.#worker, { code: "worker-died", message: "the worker was ended", hint: "" });
    this.ready = this.#untilReady();
  }

  /**
   * Finds the faces of a photo. A newer photo replaces an older one, whose promise is then rejected with `Replaced`.
   *
   * @param {Blob} photo
   * @param {number} [maxFaces]
   * @param {(stage: Stage, fraction: number) => void} [report]
   * @returns {Promise<FoundFaces>}
   */
  async find(photo, maxFaces = MAX_FACES, report = () => {}) {
    this.#rejectAll(new Replaced());
    this.start();
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, report });
      this.#post({ type: "find", id, photo, maxFaces });
      this.#watchSilence();
    });
  }

  /**
   * A photo with what was edited in it, as a file.
   *
   * @param {Edited} edited
   * @returns {Promise<Blob>}
   */
  draw(edited) {
    const buffers = [edited.from_px.buffer, edited.to_px.buffer, edited.triangles.buffer];
    return this.#ask((id) => ({ type: "draw", id, edited }), buffers, "photo-not-written");
  }

  /**
   * The texture of a whole face, RGBA.
   *
   * @param {Untextured} face
   * @returns {Promise<Uint8Array>}
   */
  texture(face) {
    return this.#ask((id) => ({ type: "texture", id, face }), [face.plan.buffer], "texture-not-made");
  }

  /**
   * @param {(id: number) => Request} request
   * @param {Transferable[]} transfer
   * @param {string} died the code of what did not come about if the worker dies
   * @returns {Promise<any>}
   */
  #ask(request, transfer, died) {
    this.start();
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#asking.set(id, { resolve, reject, died });
      this.#post(request(id), transfer);
      this.#watchSilence();
    });
  }

  /**
   * Follows a face into the next frame of a film. The worker has one frame at a time, and one waits: a newer one replaces it,
   * and its promise resolves to nothing. Frames are handed over, and closed where they do not come back; whoever is given
   * one closes it. When the worker dies, whoever waits hears so, and may go on with the next frame.
   *
   * @param {ImageBitmap} frame upright, of any size; more than 640 px on the longer side are of no use to the networks
   * @param {number} time_ms when it was taken, from any beginning
   * @returns {Promise<Followed | undefined>}
   */
  follow(frame, time_ms) {
    this.start();
    const followed = this.#following.follow(frame, time_ms);
    // Frames that come while the worker is silent do not prolong its time.
    if (this.#silence === 0) this.#watchSilence();
    return followed;
  }

  /** Forgets the face that is followed. What has not been answered resolves to nothing. */
  stopFollowing() {
    this.#following.stop();
    this.#watchSilence();
  }

  /**
   * @param {Request} request
   * @param {Transferable[]} [transfer]
   */
  #post(request, transfer = []) {
    this.#worker?.postMessage(request, transfer);
  }

  /**
   * @param {Worker} worker
   * @param {Reply} reply
   */
  #onMessage(worker, reply) {
    if (worker !== this.#worker) return;
    this.#watchSilence();
    switch (reply.type) {
      case "alive":
        return this.#noticeDeath(worker, reply.lock);
      case "loading":
        return;
      case "ready":
        this.#isReady = true;
        this.#following.open();
        return this.#nowReady();
      case "unusable":
        return this.#terminate(worker, reply.error);
      case "progress":
        return this.#waiting.get(reply.id)?.report(reply.stage, reply.fraction);
      case "found":
        return this.#settle(reply.id)?.resolve(reply.found);
      case "failed":
        return (this.#settle(reply.id) ?? this.#answered(reply.id))?.reject(reply.error);
      case "drawn":
        return this.#answered(reply.id)?.resolve(reply.file);
      case "textured":
        return this.#answered(reply.id)?.resolve(reply.pixels);
      case "followed":
        this.#following.onMessage(reply.id, reply.followed);
        return this.#watchSilence();
      case "not-followed":
        this.#following.fail(reply.id, reply.error);
        return this.#watchSilence();
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
    else this.#terminate(worker, { code: "worker-died", message: "the worker ended while loading", hint: "" });
  }

  /**
   * @param {Worker} worker
   * @param {string} message
   */
  #replace(worker, message) {
    this.#terminate(worker, { code: "worker-died", message, hint: "" });
    this.ready = this.#untilReady();
    this.start();
  }

  /**
   * @param {Worker} worker
   * @param {import("../worker/protocol.js").PageError} error
   */
  #terminate(worker, error) {
    worker.terminate();
    if (worker === this.#worker) this.#worker = undefined;
    this.#nowReady();
    this.#rejectAll(error);
    for (const [id, { died }] of [...this.#asking]) this.#answered(id)?.reject(error.code === "worker-died" ? { ...error, code: died } : error);
    this.#following.end(error);
    this.#watchSilence();
  }

  /** @param {number} id */
  #settle(id) {
    const waiting = this.#waiting.get(id);
    this.#waiting.delete(id);
    this.#watchSilence();
    return waiting;
  }

  /** @param {number} id */
  #answered(id) {
    const waiting = this.#asking.get(id);
    this.#asking.delete(id);
    this.#watchSilence();
    return waiting;
  }

  /** @param {unknown} error */
  #rejectAll(error) {
    for (const id of [...this.#waiting.keys()]) this.#settle(id)?.reject(error);
  }

  #watchSilence() {
    clearTimeout(this.#silence);
    const isAnyoneWaiting = this.#waiting.size + this.#asking.size > 0 || this.#following.isWaiting;
    this.#silence = isAnyoneWaiting ? setTimeout(() => this.#endSilence(), SILENCE_MS) : 0;
  }

  /** A worker that never came is not started again by itself: the next photo does that. */
  #endSilence() {
    const message = `silent for ${SILENCE_MS / 1000} s`;
    if (!this.#worker) return;
    if (this.#isReady) this.#replace(this.#worker, message);
    else this.#terminate(this.#worker, { code: "not-loaded", message, hint: "" });
  }

  #untilReady() {
    return new Promise((/** @type {(value: void) => void} */ resolve) => {
      this.#nowReady = resolve;
    });
  }
}

/** On a page that vouches for its files, by its policy; elsewhere, written out as bundlers look for it. */
function workerOfThisPage() {
  if (listHash()) return new Worker(ownScript("js/worker/vision-worker.js"), { type: "module" });
  return new Worker(new URL("../worker/vision-worker.js", import.meta.url), { type: "module" });
}
