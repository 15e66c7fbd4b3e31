/** @typedef {import("../worker/protocol.js").Trouble} Trouble */

/**
 * What was thrown as a trouble, whoever threw it.
 *
 * @param {unknown} thrown
 * @param {string} [code] for what brings none
 * @returns {Trouble}
 */
export function asTrouble(thrown, code = "other") {
  // A browser's own exceptions have codes that are numbers.
  if (typeof thrown === "object" && thrown !== null && "code" in thrown && typeof thrown.code === "string") {
    const { message = "", hint = "" } = /** @type {Partial<Trouble>} */ (thrown);
    return { code: thrown.code, message, hint };
  }
  return { code, message: String(thrown), hint: "" };
}
