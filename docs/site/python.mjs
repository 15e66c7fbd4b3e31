import { execFileSync } from "node:child_process";
import { join } from "node:path";

/**
 * The Python package's own documentation as Markdown, read from its sources without running them.
 *
 * @param {string} root the repository's
 */
export function pythonReference(root) {
  const script = join(root, "docs/site/python_reference.py");
  return execFileSync("python3", [script, join(root, "crates/python/rosto")], { encoding: "utf8" });
}
