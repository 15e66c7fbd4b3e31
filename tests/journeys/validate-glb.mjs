// Khronos' glTF validator over files: node tests/journeys/validate-glb.mjs FILE.glb...
// Passes only if no file draws an error, a warning, an information or a hint.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const validator = createRequire(import.meta.url)("gltf-validator");

/** @param {Uint8Array} bytes @returns {Promise<{clean: boolean, counts: string, messages: string[]}>} */
export async function validateGlb(bytes) {
  const { issues } = await validator.validateBytes(bytes);
  const counts = [issues.numErrors, issues.numWarnings, issues.numInfos, issues.numHints];
  return {
    clean: counts.every((count) => count === 0),
    counts: counts.join("/"),
    messages: issues.messages.map(({ code, message, pointer }) => `${code} ${pointer ?? ""}: ${message}`),
  };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const paths = process.argv.slice(2);
  if (paths.length === 0) {
    console.error("usage: node tests/journeys/validate-glb.mjs FILE.glb...");
    process.exitCode = 2;
  }
  for (const path of paths) {
    const verdict = await validateGlb(new Uint8Array(await readFile(path)));
    console.log([`${verdict.counts} ${path}`, ...verdict.messages].join("\n  "));
    if (!verdict.clean) process.exitCode = 1;
  }
}
