/** Runs Khronos' glTF validator, which is slow on a dense mesh. */
import { validateBytes } from "gltf-validator/gltf_validator.dart.js";
import type { Verdict } from "./verdict.ts";

const page = self as unknown as DedicatedWorkerGlobalScope;

page.addEventListener("message", async ({ data: { id, bytes } }) => page.postMessage({ id, verdict: await verdictOn(bytes) }));
page.postMessage({ ready: true });

/** Undefined if the validator failed. */
async function verdictOn(bytes: Uint8Array): Promise<Verdict | undefined> {
  try {
    const { issues } = await validateBytes(bytes, { writeTimestamp: false });
    return { errors: issues.numErrors, warnings: issues.numWarnings, remarks: issues.numInfos + issues.numHints };
  } catch {
    return undefined;
  }
}
