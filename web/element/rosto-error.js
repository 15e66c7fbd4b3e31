import { asPageError } from "../js/page/page-error.js";

/** An error with a stable code for programs, and an English message for developers. */
export class RostoError extends Error {
  name = "RostoError";

  /**
   * @param {string} code such as "no-face-found"
   * @param {string} message
   * @param {string} [hint] what to do about it
   */
  constructor(code, message, hint = "") {
    super(message);
    this.code = code;
    this.hint = hint;
  }

  /**
   * Wraps any thrown value.
   *
   * @param {unknown} thrown
   */
  static of(thrown) {
    if (thrown instanceof RostoError) return thrown;
    const { code, message, hint } = asPageError(thrown);
    return new RostoError(code, message, hint);
  }
}
