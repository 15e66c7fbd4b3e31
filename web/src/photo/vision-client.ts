import { fileUrl } from "../files.ts";
import { scriptUrl } from "../trusted.ts";
import { FrameQueue } from "./frame-queue.ts";
import type { FaceTask, FollowedFrame, Opened, PageError, Reply, Request, Stage } from "../worker/protocol.ts";
import type { SourceFile } from "../work/face.ts";

export interface Pending {
  resolve: (answer: any) => void;
  reject: (error: unknown) => void;
  report: (stage: Stage, fraction: number) => void;
  /** error code if the worker dies */
  diedCode: string;
}

/** Watchdog timeout while requests are pending. A worker that is loading reports progress, which resets it. */
const SILENCE_MS = 60_000;

/** Client of the vision worker; starts it, and restarts it after a crash. */
export class VisionClient {
  #worker: Worker | undefined;
  #pending: Map<number, Pending> = new Map();
  #lastId = 0;
  #watchdog = 0;
  #starts = 0;
  #isReady = false;
  #frames = new FrameQueue((request, transfer) => this.#post(request, transfer));
  /** Resolves once the worker has loaded or failed to. */
  ready: Promise<void>;
  #resolveReady: () => void = (): void => {};

  constructor() {
    this.ready = this.#untilReady();
  }

  /** Number of workers started so far. */
  get starts() {
    return this.#starts;
  }

  /** Starts the worker if none is running. */
  start() {
    if (this.#worker) return;
    this.#starts += 1;
    this.#isReady = false;
    const worker = new Worker(scriptUrl(fileUrl(new URL("./vision-worker.js", import.meta.url))));
    worker.addEventListener("message", (event) => this.#onMessage(worker, event.data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      this.#terminate(worker, { code: "not-loaded", message: event.message ?? "", hint: "" });
    });
    this.#worker = worker;
    const module = fileUrl(new URL("./rosto-vision-web_bg.wasm", import.meta.url)).href;
    const detector = fileUrl(new URL("./face_detector.onnx", import.meta.url)).href;
    const landmarks = fileUrl(new URL("./face_landmarks_attention.onnx", import.meta.url)).href;
    this.#post({ type: "load", module, detector, landmarks });
  }

  /** Terminates the worker, which frees its memory and rejects pending requests. The next request starts another. */
  end() {
    if (this.#worker) this.#terminate(this.#worker, { code: "worker-died", message: "the worker was ended", hint: "" });
    this.ready = this.#untilReady();
  }

  /** Opens a photo, GLB or project: finds its faces, most prominent first. */
  open(file: Blob, report?: (stage: Stage, fraction: number) => void): Promise<Opened> {
    return this.#request((id) => ({ type: "open", id, key: crypto.randomUUID(), file }), "worker-died", report);
  }

  /**
   * A picture of a face, upright.
   *
   * @param files that contain it
   */
  picture(picture: string, files: SourceFile[]): Promise<ImageBitmap> {
    return this.perform({ type: "picture", picture }, files, "worker-died");
  }

  /**
   * Performs a task on a face.
   *
   * @param files with the pictures that it reads
   * @param diedCode error code if the worker dies
   */
  perform(task: FaceTask, files: SourceFile[], diedCode: string) {
    return this.#request((id) => ({ ...task, id, files }), diedCode);
  }

  /** @param diedCode error code if the worker dies */
  #request(request: (id: number) => Request, diedCode: string, report: (stage: Stage, fraction: number) => void = () => {}): Promise<any> {
    this.start();
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, report, diedCode });
      this.#post(request(id));
      this.#resetWatchdog();
    });
  }

  /**
   * Follows a face into the next frame of a video. One frame is processed at a time and one waits. A newer frame
   * replaces the waiting one, whose promise resolves to undefined. Takes ownership of `frame`; the caller closes the
   * frame in the result. If the worker dies, the promise rejects, and the next frame starts another worker.
   *
   * @param frame upright, of any size; frames over 640 px on the longer side are scaled down
   * @param time_ms timestamp, from any origin
   */
  follow(frame: ImageBitmap, time_ms: number): Promise<FollowedFrame | undefined> {
    this.start();
    const followed = this.#frames.follow(frame, time_ms);
    // New frames do not extend the timeout of a silent worker.
    if (this.#watchdog === 0) this.#resetWatchdog();
    return followed;
  }

  /** Stops following; pending frames resolve to undefined. */
  stopFollowing() {
    this.#frames.stop();
    this.#resetWatchdog();
  }

  #post(request: Request, transfer: Transferable[] = []) {
    this.#worker?.postMessage(request, transfer);
  }

  #onMessage(worker: Worker, reply: Reply) {
    if (worker !== this.#worker) return;
    this.#resetWatchdog();
    switch (reply.type) {
      case "alive":
        return this.#watchForDeath(worker, reply.lock);
      case "loading":
        return;
      case "ready":
        this.#isReady = true;
        this.#frames.open();
        return this.#resolveReady();
      case "unusable":
        return this.#terminate(worker, reply.error);
      case "progress":
        return this.#pending.get(reply.id)?.report(reply.stage, reply.fraction);
      case "failed":
        return this.#take(reply.id)?.reject(reply.error);
      case "followed":
        this.#frames.onMessage(reply.id, reply.followed);
        return this.#resetWatchdog();
      case "not-followed":
        this.#frames.fail(reply.id, reply.error);
        return this.#resetWatchdog();
      case "trapped":
        return this.#restart(worker, reply.message);
      default:
        return this.#take(reply.id)?.resolve(reply.answer);
    }
  }

  /** Waits for a lock that the worker holds while it lives: it is granted once the worker has ended. */
  async #watchForDeath(worker: Worker, lock: string) {
    await navigator.locks.request(lock, () => {});
    if (worker !== this.#worker) return;
    // Do not restart a worker that died while loading, as it would fail again; the next request retries.
    if (this.#isReady) this.#restart(worker, "the worker ended");
    else this.#terminate(worker, { code: "worker-died", message: "the worker ended while loading", hint: "" });
  }

  #restart(worker: Worker, message: string) {
    this.#terminate(worker, { code: "worker-died", message, hint: "" });
    this.ready = this.#untilReady();
    this.start();
  }

  #terminate(worker: Worker, error: PageError) {
    worker.terminate();
    if (worker === this.#worker) this.#worker = undefined;
    this.#resolveReady();
    for (const [id, { diedCode }] of [...this.#pending]) this.#take(id)?.reject(error.code === "worker-died" ? { ...error, code: diedCode } : error);
    this.#frames.end(error);
    this.#resetWatchdog();
  }

  #take(id: number) {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    this.#resetWatchdog();
    return pending;
  }

  #resetWatchdog() {
    clearTimeout(this.#watchdog);
    const isPending = this.#pending.size > 0 || this.#frames.isWaiting;
    this.#watchdog = isPending ? setTimeout(() => this.#onSilence(), SILENCE_MS) : 0;
  }

  /** Restarts the worker, unless it has not loaded: then the next request retries. */
  #onSilence() {
    const message = `silent for ${SILENCE_MS / 1000} s`;
    if (!this.#worker) return;
    if (this.#isReady) this.#restart(this.#worker, message);
    else this.#terminate(this.#worker, { code: "not-loaded", message, hint: "" });
  }

  #untilReady() {
    return new Promise<void>((resolve) => {
      this.#resolveReady = resolve;
    });
  }
}
