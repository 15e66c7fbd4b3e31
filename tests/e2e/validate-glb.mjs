// Khronos' glTF validator over files: node tests/e2e/validate-glb.mjs FILE.glb...
// Passes only if no file draws an error, a warning, an information or a hint.
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
