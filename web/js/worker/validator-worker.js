/**
 * Runs Khronos' glTF validator, which is slow on a dense mesh. A classic worker, because the validator is a CommonJS
 * script that assigns to `exports`.
 *
 * @typedef {{ numErrors: number, numWarnings: number, numInfos: number, numHints: number }} GltfIssues
 * @typedef {{ validateBytes: (bytes: Uint8Array, options: object) => Promise<{ issues: GltfIssues }> }} GltfValidator
 */
const validatorScope = /** @type {DedicatedWorkerGlobalScope & { exports: GltfValidator }} */ (/** @type {unknown} */ (self));

const VALIDATOR = "../../vendor/gltf-validator/gltf_validator.dart.js";

validatorScope.exports = /** @type {GltfValidator} */ ({});
validatorScope.importScripts(trustedUrl(VALIDATOR));

validatorScope.addEventListener("message", async ({ data: { id, bytes } }) => {
  validatorScope.postMessage({ id, verdict: await validate(bytes) });
});
validatorScope.postMessage({ ready: true });

/**
 * Passes a URL through a Trusted Types policy that accepts only the validator. Classic workers cannot import the page's
 * policy.
 *
 * @param {string} url
 */
function trustedUrl(url) {
  const { trustedTypes } = /** @type {{ trustedTypes?: import("../page/trusted.js").PolicyFactory }} */ (globalThis);
  const refuse = () => {
    throw new TypeError("this worker loads only the validator");
  };
  const rules = { createScriptURL: (/** @type {string} */ script) => (script === VALIDATOR ? script : refuse()), createHTML: refuse };
  return (trustedTypes?.createPolicy("rosto", rules) ?? rules).createScriptURL(url);
}

/**
 * @param {Uint8Array} bytes
 * @returns {Promise<import("./protocol.js").Verdict | undefined>} undefined if the validator failed
 */
async function validate(bytes) {
  try {
    const { issues } = await validatorScope.exports.validateBytes(bytes, { writeTimestamp: false });
    return { errors: issues.numErrors, warnings: issues.numWarnings, remarks: issues.numInfos + issues.numHints };
  } catch {
    return undefined;
  }
}
