/** @typedef {import("../worker/protocol.js").PageError} PageError */

/**
 * Converts any thrown value into an error with a code.
 *
 * @param {unknown} thrown
 * @param {string} [code] used if the value has none
 * @returns {PageError}
 */
export function asPageError(thrown, code = "other") {
  // DOMException has numeric codes.
  if (typeof thrown === "object" && thrown !== null && "code" in thrown && typeof thrown.code === "string") {
    const { message = "", hint = "", maxMm } = /** @type {Partial<PageError>} */ (thrown);
    return { code: thrown.code, message, hint, ...(maxMm !== undefined && { maxMm }) };
  }
  return { code, message: String(thrown), hint: "" };
}

/** The error for a photo without a face. @returns {PageError} */
export function noFace() {
  return { code: "no-face-found", message: "no face in the photo", hint: "" };
}
