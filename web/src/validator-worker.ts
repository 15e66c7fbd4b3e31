/** Runs Khronos' glTF validator, which is slow on a dense mesh. */
import { validateBytes } from "gltf-validator/gltf_validator.dart.js";

const page = self as unknown as DedicatedWorkerGlobalScope;

page.addEventListener("message", async ({ data: { id, bytes } }) => {
  // Without a verdict if the validator fails.
  page.postMessage({ id, verdict: await verdictOn(bytes).catch(() => undefined) });
});
page.postMessage({ ready: true });

async function verdictOn(bytes: Uint8Array) {
  const { issues } = await validateBytes(bytes, { writeTimestamp: false });
  return { errors: issues.numErrors, warnings: issues.numWarnings, remarks: issues.numInfos + issues.numHints };
}
