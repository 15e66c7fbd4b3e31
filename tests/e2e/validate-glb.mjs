// Validates files with Khronos' glTF validator: node tests/e2e/validate-glb.mjs FILE.glb...
// Fails if a file has an error, warning, information or hint.
import { readFile } from "node:fs/promises";
import validator from "gltf-validator";

/** @param {Uint8Array} bytes @returns {Promise<{clean: boolean, counts: string, messages: string[]}>} */
export async function validateGlb(bytes) {
  const { issues } = await validator.validateBytes(new Uint8Array(bytes));
  const counts = [issues.numErrors, issues.numWarnings, issues.numInfos, issues.numHints].join("/");
  const messages = issues.messages.map(({ code, message, pointer }) => `${code} ${pointer ?? ""}: ${message}`);
  return { clean: counts === "0/0/0/0", counts, messages };
}

if (process.argv[1] === import.meta.filename) {
  for (const path of process.argv.slice(2)) {
    const { clean, counts, messages } = await validateGlb(await readFile(path));
    console.log([`${counts} ${path}`, ...messages].join("\n  "));
    if (!clean) process.exitCode = 1;
  }
}
