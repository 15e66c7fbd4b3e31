import { asPageError } from "../page/page-error.ts";

/** An error with a stable code for programs, and an English message for developers. */
export class RostoError extends Error {
  name = "RostoError";
  readonly code: string;
  readonly hint: string;

  /**
   * @param code such as "no-face-found"
   * @param hint what to do about it
   */
  constructor(code: string, message: string, hint: string = "") {
    super(message);
    this.code = code;
    this.hint = hint;
  }

  /** Wraps any thrown value. */
  static of(thrown: unknown) {
    if (thrown instanceof RostoError) return thrown;
    const { code, message, hint } = asPageError(thrown);
    return new RostoError(code, message, hint);
  }
}
