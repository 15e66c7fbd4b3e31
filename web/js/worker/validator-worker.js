/**
 * Runs Khronos' glTF validator, which takes its time over a dense mesh. A classic worker: the validator is a script that
 * looks for an `exports` to fill.
 *
 * @typedef {{ numErrors: number, numWarnings: number, numInfos: number, numHints: number }} GltfIssues
 * @typedef {{ validateBytes: (bytes: Uint8Array, options: object) => Promise<{ issues: GltfIssues }> }} GltfValidator
 */
const validatorScope = /** @type {DedicatedWorkerGlobalScope & { exports: GltfValidator }} */ (/** @type {unknown} */ (self));

const VALIDATOR = "../../vendor/gltf-validator/gltf_validator.dart.js";

validatorScope.exports = /** @type {GltfValidator} */ ({});
validatorScope.importScripts(trusted(VALIDATOR));

validatorScope.addEventListener("message", async ({ data: { id, bytes } }) => {
  validatorScope.postMessage({ id, verdict: await verdictOn(bytes) });
});
validatorScope.postMessage({ ready: true });

/**
 * Classic workers cannot import the page's policy: this one accepts the validator's address alone.
 *
 * @param {string} address
 */
function trusted(address) {
  const { trustedTypes } = /** @type {{ trustedTypes?: import("../page/trusted.js").PolicyFactory }} */ (globalThis);
  const refuse = () => {
    throw new TypeError("this worker runs the validator only");
  };
  const rules = { createScriptURL: (/** @type {string} */ script) => (script === VALIDATOR ? script : refuse()), createHTML: refuse };
  return (trustedTypes?.createPolicy("rosto", rules) ?? rules).createScriptURL(address);
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
