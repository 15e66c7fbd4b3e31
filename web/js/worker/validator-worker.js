/**
 * Runs Khronos' glTF validator, which takes its time over a dense mesh. A classic worker: the validator is a script that
 * looks for an `exports` to fill.
 *
 * @typedef {{ numErrors: number, numWarnings: number, numInfos: number, numHints: number }} GltfIssues
 * @typedef {{ validateBytes: (bytes: Uint8Array, options: object) => Promise<{ issues: GltfIssues }> }} GltfValidator
 */
const validatorScope = /** @type {DedicatedWorkerGlobalScope & { exports: GltfValidator }} */ (/** @type {unknown} */ (self));

validatorScope.exports = /** @type {GltfValidator} */ ({});
validatorScope.importScripts(trusted("../../vendor/gltf-validator/gltf_validator.dart.js"));

validatorScope.addEventListener("message", async ({ data: { id, bytes } }) => {
  validatorScope.postMessage({ id, verdict: await verdictOn(bytes) });
});
validatorScope.postMessage({ ready: true });

/**
 * A classic worker has no modules, the page's policy for scripts among them: this is the same for the one script here.
 *
 * @param {string} script
 */
function trusted(script) {
  const { trustedTypes } = /** @type {{ trustedTypes?: import("../page/trusted.js").PolicyFactory }} */ (globalThis);
  const rules = { createScriptURL: () => script, createHTML: () => "" };
  return (trustedTypes?.createPolicy("rosto", rules) ?? rules).createScriptURL(script);
}

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<import("./protocol.js").Verdict | undefined>} nothing where the validator gave up
 */
async function verdictOn(bytes) {
  try {
    const { issues } = await validatorScope.exports.validateBytes(bytes, { writeTimestamp: false });
    return { errors: issues.numErrors, warnings: issues.numWarnings, remarks: issues.numInfos + issues.numHints };
  } catch {
    return undefined;
  }
}
