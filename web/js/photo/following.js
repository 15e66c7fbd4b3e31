/**
 * @typedef {import("../worker/protocol.js").Request} Request
 * @typedef {import("../worker/protocol.js").Followed} Followed
 * @typedef {import("../worker/protocol.js").PageError} PageError
 *
 * @typedef {object} Asked a frame that somebody waits for
 * @property {ImageBitmap} frame
 * @property {number} time_ms
 * @property {(followed: Followed | undefined) => void} resolve
 * @property {(error: unknown) => void} reject
 */

/**
 * Frames on their way to the worker and back. The worker has one, and one waits: a newer frame takes the place of the one
 * that waits, so that no answer is older than two frames.
 */
export class Following {
  #post;
  #isOpen = false;
  #lastId = 0;
  /** Whether the worker has a frame, though nobody may wait for it any more. */
  #isBusy = false;
  /** @type {Asked | undefined} */
  #sent;
  /** @type {Asked | undefined} */
  #next;

  /** @param {(request: Request, transfer?: Transferable[]) => void} post */
  constructor(post) {
    this.#post = post;
  }

  /** Whether somebody waits for the worker. */
  get isWaiting() {
    return Boolean(this.#sent ?? this.#next);
  }

  /** The worker has loaded. Before, it is sent nothing: the frame would be old by the time it is looked at. */
  open() {
    this.#isOpen = true;
    this.#send();
  }

  /**
   * @param {ImageBitmap} frame
   * @param {number} time_ms
   * @returns {Promise<Followed | undefined>}
   */
  follow(frame, time_ms) {
    this.#passOver();
    return new Promise((resolve, reject) => {
      this.#next = { frame, time_ms, resolve, reject };
      this.#send();
    });
  }

  /** Nobody waits any more; the next frame belongs to another film. */
  stop() {
    this.#passOver();
    this.#sent?.resolve(undefined);
    this.#sent = undefined;
    if (this.#isOpen) this.#post({ type: "stop-following" });
  }

  /**
   * @param {number} id
   * @param {Followed} followed
   */
  onMessage(id, followed) {
    const asked = this.#take(id);
    if (asked) asked.resolve(followed);
    // Whoever no longer waits for the frame does not close it either.
    else followed.frame.close();
    this.#send();
  }

  /**
   * @param {number} id
   * @param {PageError} error
   */
  fail(id, error) {
    this.#take(id)?.reject(error);
    this.#send();
  }

  /**
   * The worker is gone, and the frame that it had with it.
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
  #take(id) {
    if (id !== this.#lastId) return undefined;
    const asked = this.#sent;
    this.#sent = undefined;
    this.#isBusy = false;
    return asked;
  }

  /** Lets go of the frame that waits. */
  #passOver() {
    this.#next?.frame.close();
    this.#next?.resolve(undefined);
    this.#next = undefined;
  }
}
