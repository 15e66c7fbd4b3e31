/** @typedef {import("../worker/protocol.js").PageError} PageError */

/**
 * What was thrown as an error, whoever threw it.
 *
 * @param {unknown} thrown
 * @param {string} [code] for what brings none
 * @returns {PageError}
 */
export function asPageError(thrown, code = "other") {
  // A browser's own exceptions have codes that are numbers.
  if (typeof thrown === "object" && thrown !== null && "code" in thrown && typeof thrown.code === "string") {
    const { message = "", hint = "" } = /** @type {Partial<PageError>} */ (thrown);
    return { code: thrown.code, message, hint };
  }
  return { code, message: String(thrown), hint: "" };
}

/** What is thrown about a photo without a face. @returns {PageError} */
export function noFace() {
  return { code: "no-face-found", message: "no face in the photo", hint: "" };
}
