/**
 * Runs Khronos' glTF validator, which takes its time over a dense mesh. A classic worker: the validator is a script that
 * looks for an `exports` to fill.
 *
 * @typedef {import("./protocol.js").Verdict} Verdict
 * @typedef {{ validateBytes: (bytes: Uint8Array, options: object) => Promise<Report> }} Validator
 * @typedef {{ issues: { numErrors: number, numWarnings: number, numInfos: number, numHints: number } }} Report
 */
const scope = /** @type {WorkerGlobalScope & { exports: Validator }} */ (/** @type {unknown} */ (self));

scope.exports = /** @type {Validator} */ ({});
importScripts("../../vendor/gltf-validator/gltf_validator.dart.js");

self.addEventListener("message", async (event) => {
  const { id, bytes } = event.data;
  self.postMessage({ id, verdict: await verdictOn(bytes) });
});
self.postMessage({ ready: true });

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<Verdict | undefined>} nothing where the validator gave up
 */
async function verdictOn(bytes) {
  try {
    const { issues } = await scope.exports.validateBytes(bytes, { writeTimestamp: false });
    return { errors: issues.numErrors, warnings: issues.numWarnings, remarks: issues.numInfos + issues.numHints };
  } catch {
    return undefined;
  }
}
