// Prints Criterion's medians, one JSON object per line: node tests/bench/criterion.mjs target/criterion
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";

const [root] = process.argv.slice(2);
const folders = readdirSync(root, { recursive: true }).map(String).filter((name) => path.basename(name) === "new");
for (const folder of folders) {
  const read = (/** @type {string} */ name) => JSON.parse(readFileSync(path.join(root, folder, name), "utf8"));
  const { group_id: task, function_id: what, value_str: size } = read("benchmark.json");
  const value = read("estimates.json").median.point_estimate / 1e6;
  console.log(JSON.stringify({ task, what, size, peer: "rosto", value, unit: "ms", samples: read("sample.json").times.length }));
}
