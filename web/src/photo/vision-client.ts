import { fileUrl } from "../files.ts";
import { scriptUrl } from "../trusted.ts";
import { transferable } from "../worker/protocol.ts";
import type { Answer, Argument, FollowedFrame, Opened, PageError, Reply, Report } from "../worker/protocol.ts";
import type { Tasks } from "../worker/tasks.ts";

interface Pending {
  type: keyof Tasks;
  resolve: (answer: any) => void;
  reject: (error: PageError) => void;
  report: Report | undefined;
}

/** Watchdog timeout while requests are pending. A worker that is loading reports progress, which resets it. */
const SILENCE_MS = 60_000;

/** Error code of a task whose worker dies. */
const DIED: { [Name in keyof Tasks]?: string } = {
  write: "file-not-written",
  "write-project": "file-not-written",
  "edited-photo": "photo-not-written",
};

/** Client of the vision worker; starts it, and restarts it after a crash. */
export class VisionClient {
  #worker: Worker | undefined;
  #pending: Map<number, Pending> = new Map();
  #lastId = 0;
  #watchdog = 0;
  #isReady = false;
  /** The camera frame that waits for the answer to the last one. */
  #nextFrame: ImageBitmap | undefined;
  /** Settles when the worker has answered the camera frame that it has. */
  #followed: Promise<unknown> | undefined;
  /** Number of camera streams so far. */
  #streams = 0;
  /** Resolves once the started worker has loaded or failed to. */
  ready: Promise<unknown> = Promise.resolve();

  /** Starts the worker if none is running. */
  start() {
    if (this.#worker || !isSecureContext) return;
    const worker = new Worker(scriptUrl(fileUrl(new URL("./vision-worker.js", import.meta.url))));
    worker.addEventListener("message", ({ data }) => worker === this.#worker && this.#onReply(worker, data));
    worker.addEventListener("error", (event) => {
      event.preventDefault();
      if (worker === this.#worker) this.#replace(event.message);
    });
    this.#worker = worker;
    const module = fileUrl(new URL("./rosto-vision-web_bg.wasm", import.meta.url)).href;
    const detector = fileUrl(new URL("./face_detector.onnx", import.meta.url)).href;
    const landmarks = fileUrl(new URL("./face_landmarks_attention.onnx", import.meta.url)).href;
    this.ready = this.request("load", { module, networks: [detector, landmarks] }).then(
      () => {
        this.#isReady = true;
      },
      (error) => worker === this.#worker && this.#end(error),
    );
  }

  /** Terminates the worker, which frees its memory and rejects pending requests. The next request starts another. */
  end() {
    this.#end({ code: "worker-died", message: "the worker was ended", hint: "" });
  }

  /** Cancels all pending requests; they reject with the code "cancelled". */
  cancel() {
    this.#end({ code: "cancelled", message: "cancelled by the visitor", hint: "" });
    this.start();
  }

  /** Opens a photo, GLB or project: finds its faces, most prominent first. */
  open(file: Blob, report?: Report): Promise<Opened> {
    return this.request("open", { file }, report);
  }

  /** Asks the worker to perform a task. */
  request<Name extends keyof Tasks>(type: Name, argument: Argument<Name>, report?: Report) {
    this.start();
    return new Promise<Answer<Name>>((resolve, reject) => {
      if (!this.#worker) return reject({ code: "needs-https", message: "not a secure context", hint: "" });
      const id = ++this.#lastId;
      this.#pending.set(id, { type, resolve, reject, report });
      this.#worker.postMessage({ ...argument, type, id }, transferable(argument));
      this.#resetWatchdog();
    });
  }

  /**
   * Follows a face into the next frame of a video. One frame is processed at a time and one waits; a newer frame
   * replaces the waiting one. Takes ownership of `frame`; the caller closes the frame in the result. Resolves to
   * undefined for a frame that was replaced, or whose stream was stopped. Rejects if the worker dies; the next frame
   * starts another one.
   *
   * @param frame upright, of any size; frames over 640 px on the longer side are scaled down
   * @param time_ms timestamp, from any origin
   */
  async follow(frame: ImageBitmap, time_ms: number): Promise<FollowedFrame | undefined> {
    this.start();
    this.#nextFrame?.close();
    this.#nextFrame = frame;
    const stream = this.#streams;
    // A frame sent to a worker that is loading would be stale when processed.
    if (!this.#isReady || this.#followed) await Promise.all([this.ready, this.#followed]);
    if (this.#nextFrame !== frame) return undefined;
    this.#nextFrame = undefined;
    const answer = this.request("follow", { frame, time_ms });
    const onAnswer = () => (this.#followed = undefined);
    this.#followed = answer.then(onAnswer, onAnswer);
    const followed = await answer;
    if (stream === this.#streams) return followed;
    followed.frame.close();
    return undefined;
  }

  /** Stops following; pending frames resolve to undefined. The next frame begins another stream. */
  stopFollowing() {
    this.#nextFrame?.close();
    this.#nextFrame = undefined;
    this.#streams += 1;
    if (this.#isReady) this.request("stop-following", {}).catch(() => {});
  }

  #onReply(worker: Worker, reply: Reply) {
    if (reply.type === "alive") this.#watchForDeath(worker, reply.lock);
    else if (reply.type === "trapped") this.#replace(reply.message, "worker-died");
    else if (reply.type === "progress") this.#pending.get(reply.id)?.report?.(reply.stage, reply.fraction);
    else if (reply.type === "failed") this.#take(reply.id)?.reject(reply.error);
    else if (reply.type !== "loading") this.#take(reply.id)?.resolve(reply.answer);
    this.#resetWatchdog();
  }

  #take(id: number) {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    return pending;
  }

  /** Waits for a lock that the worker holds while it lives: it is granted once the worker has ended. */
  async #watchForDeath(worker: Worker, lock: string) {
    await navigator.locks.request(lock, () => {});
    if (worker === this.#worker) this.#replace("the worker ended");
  }

  /** Replaces a worker that has died. One that died while loading would fail again, so the next request retries. */
  #replace(message: string, code = this.#isReady ? "worker-died" : "not-loaded") {
    const wasReady = this.#isReady;
    this.#end({ code, message, hint: "" });
    if (wasReady) this.start();
  }

  #end(error: PageError) {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#isReady = false;
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    this.#resetWatchdog();
    for (const { type, reject } of pending) {
      reject({ ...error, code: (error.code === "worker-died" && DIED[type]) || error.code });
    }
  }

  #resetWatchdog() {
    clearTimeout(this.#watchdog);
    const onSilence = () => this.#replace(`silent for ${SILENCE_MS / 1000} s`);
    this.#watchdog = this.#pending.size > 0 ? setTimeout(onSilence, SILENCE_MS) : 0;
  }
}
