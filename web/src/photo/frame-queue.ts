import type { FollowedFrame, PageError, Request as WorkerRequest } from "../worker/protocol.ts";

type Request = WorkerRequest;

export interface PendingFrame {
  frame: ImageBitmap;
  time_ms: number;
  resolve: (followed: FollowedFrame | undefined) => void;
  reject: (error: unknown) => void;
}

/**
 * Queue of camera frames for the worker: one is in flight and one waits. A newer frame replaces the waiting one, which
 * bounds the latency to two frames.
 */
export class FrameQueue {
  #post;
  #isOpen = false;
  #lastId = 0;
  /** Whether a frame is in flight, even if its result is no longer needed. */
  #isBusy = false;
  #sent: PendingFrame | undefined;
  #next: PendingFrame | undefined;

  constructor(post: (request: Request, transfer?: Transferable[]) => void) {
    this.#post = post;
  }

  /** Whether a result is pending. */
  get isWaiting() {
    return Boolean(this.#sent ?? this.#next);
  }

  /** Starts sending, once the worker has loaded: a frame sent earlier would be stale when processed. */
  open() {
    this.#isOpen = true;
    this.#send();
  }

  follow(frame: ImageBitmap, time_ms: number): Promise<FollowedFrame | undefined> {
    this.#dropNext();
    return new Promise((resolve, reject) => {
      this.#next = { frame, time_ms, resolve, reject };
      this.#send();
    });
  }

  /** Cancels the pending frames; the next frame starts another stream. */
  stop() {
    this.#dropNext();
    this.#sent?.resolve(undefined);
    this.#sent = undefined;
    if (this.#isOpen) this.#post({ type: "stop-following" });
  }

  onMessage(id: number, followed: FollowedFrame) {
    const pending = this.#settle(id);
    if (pending) pending.resolve(followed);
    // Cancelled: the caller will not close the frame.
    else followed.frame.close();
    this.#send();
  }

  fail(id: number, error: PageError) {
    this.#settle(id)?.reject(error);
    this.#send();
  }

  /** Rejects the pending frames after the worker has ended. */
  end(error: unknown) {
    this.#isOpen = false;
    this.#isBusy = false;
    this.#sent?.reject(error);
    this.#sent = undefined;
    this.#next?.frame.close();
    this.#next?.reject(error);
    this.#next = undefined;
  }

  #send() {
    const next = this.#next;
    if (!next || !this.#isOpen || this.#isBusy) return;
    this.#next = undefined;
    this.#sent = next;
    this.#isBusy = true;
    const { frame, time_ms } = next;
    this.#post({ type: "follow", id: ++this.#lastId, frame, time_ms }, [frame]);
  }

  #settle(id: number) {
    if (id !== this.#lastId) return undefined;
    const pending = this.#sent;
    this.#sent = undefined;
    this.#isBusy = false;
    return pending;
  }

  /** Drops the waiting frame. */
  #dropNext() {
    this.#next?.frame.close();
    this.#next?.resolve(undefined);
    this.#next = undefined;
  }
}
