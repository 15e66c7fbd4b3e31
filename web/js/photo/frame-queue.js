/**
 * @typedef {import("../worker/protocol.js").Request} Request
 * @typedef {import("../worker/protocol.js").FollowedFrame} FollowedFrame
 * @typedef {import("../worker/protocol.js").PageError} PageError
 *
 * @typedef {object} PendingFrame
 * @property {ImageBitmap} frame
 * @property {number} time_ms
 * @property {(followed: FollowedFrame | undefined) => void} resolve
 * @property {(error: unknown) => void} reject
 */

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
  /** @type {PendingFrame | undefined} */
  #sent;
  /** @type {PendingFrame | undefined} */
  #next;

  /** @param {(request: Request, transfer?: Transferable[]) => void} post */
  constructor(post) {
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

  /**
   * @param {ImageBitmap} frame
   * @param {number} time_ms
   * @returns {Promise<FollowedFrame | undefined>}
   */
  follow(frame, time_ms) {
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

  /**
   * @param {number} id
   * @param {FollowedFrame} followed
   */
  onMessage(id, followed) {
    const pending = this.#settle(id);
    if (pending) pending.resolve(followed);
    // Cancelled: the caller will not close the frame.
    else followed.frame.close();
    this.#send();
  }

  /**
   * @param {number} id
   * @param {PageError} error
   */
  fail(id, error) {
    this.#settle(id)?.reject(error);
    this.#send();
  }

  /**
   * Rejects the pending frames after the worker has ended.
   *
   * @param {unknown} error
   */
  end(error) {
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

  /** @param {number} id */
  #settle(id) {
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
