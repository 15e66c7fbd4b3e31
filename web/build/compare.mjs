// Compares a published page with a local build, file by file: node web/build/compare.mjs URL [FOLDER]. The folder
// defaults to dist/.
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";

const [address, folder = "dist"] = process.argv.slice(2);
if (!address) throw new Error("missing URL; usage: node web/build/compare.mjs https://…/ [FOLDER]");
const published = new URL(address.endsWith("/") ? address : `${address}/`);

/** Files that hosts read and do not serve. */
const UNSERVED = new Set(["_headers", "vercel.json", "nginx.conf"]);
const entries = await readdir(folder, { recursive: true, withFileTypes: true });
const files = entries.filter((entry) => entry.isFile() && !entry.name.startsWith(".") && !UNSERVED.has(entry.name));
const names = files.map((entry) => path.relative(folder, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/"));
let differing = 0;
for (const name of names) {
  const difference = await differenceOf(name);
  if (!difference) continue;
  differing += 1;
  console.log(`✗ ${name}: ${difference}`);
}
console.log(differing === 0 ? `all ${names.length} files are identical` : `${differing} of ${names.length} files differ`);
process.exitCode = differing === 0 ? 0 : 1;

/** @param {string} name */
async function differenceOf(name) {
  // Request the folder, as some hosts redirect index.html to it.
  const response = await fetch(name === "index.html" ? published : new URL(name, published));
  if (!response.ok) return `status ${response.status}`;
  const theirs = Buffer.from(await response.arrayBuffer());
  return theirs.equals(await readFile(path.join(folder, name))) ? undefined : "content differs";
}
