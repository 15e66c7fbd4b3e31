// Tells whether a published page is the one that was built here, file by file: node web/compare-published.mjs ADDRESS
// [FOLDER]. The folder is dist/ if none is named.
import { readFile } from "node:fs/promises";
import path from "node:path";

const [address, folder = "dist"] = process.argv.slice(2);
if (!address) throw new Error("whose address? node web/compare-published.mjs https://…/ [FOLDER]");
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
console.log(differing === 0 ? `every one of ${names.length} files is the same` : `${differing} of ${names.length} files differ`);
process.exitCode = differing === 0 ? 0 : 1;

/** @param {string} name */
async function differenceOf(name) {
  // A host gives the page for its folder; some send whoever asks for its name there.
  const answer = await fetch(name === "index.html" ? published : new URL(name, published));
  if (!answer.ok) return `the host answers ${answer.status}`;
  const theirs = Buffer.from(await answer.arrayBuffer());
  return theirs.equals(await readFile(path.join(folder, name))) ? undefined : "other bytes";
}
