// Compares a published page with a local build, file by file: node web/compare-published.mjs URL [FOLDER]. The folder
// defaults to dist/.
import { readFile } from "node:fs/promises";
import path from "node:path";

const [address, folder = "dist"] = process.argv.slice(2);
if (!address) throw new Error("missing URL; usage: node web/compare-published.mjs https://…/ [FOLDER]");
const published = new URL(address.endsWith("/") ? address : `${address}/`);

const { files } = JSON.parse(String(await readFile(path.join(folder, "integrity.json"))));
const names = ["index.html", "integrity.json", "service-worker.js", ...Object.keys(files)];
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
