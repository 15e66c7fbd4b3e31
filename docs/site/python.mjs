import { execFileSync } from "node:child_process";
import { join } from "node:path";

/**
 * The Python package's signatures and docstrings as Markdown. The sources are parsed, not imported.
 *
 * @param {string} root of the repository
 */
export function pythonReference(root) {
  const script = join(root, "docs/site/python_reference.py");
  return execFileSync("python3", [script, join(root, "crates/python/rosto")], { encoding: "utf8" });
}
