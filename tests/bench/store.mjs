// Stores measurements in docs/benchmarks.json: node tests/bench/store.mjs LINES
//
// Replaces the records of the same tasks and peers. `node docs/figures.mjs` then updates the documentation.
import { readFileSync, writeFileSync } from "node:fs";
import { cpus } from "node:os";

const RESULTS = new URL("../../docs/benchmarks.json", import.meta.url);
const [lines] = process.argv.slice(2);
const machine = `${cpus()[0].model}, ${cpus().length} cores`;

const measured = readFileSync(lines, "utf8").split("\n").filter((line) => line.startsWith("{")).map((line) => JSON.parse(line));
if (measured.length === 0) throw new Error(`${lines} has no measurements`);
const subject = ({ task, what, size }) => [task, what, size].join("|");
const source = ({ task, peer }) => [task, peer].join("|");
const replaced = new Set(measured.map(source));
const kept = JSON.parse(readFileSync(RESULTS, "utf8")).filter((record) => !replaced.has(source(record)));
const records = [...kept, ...measured.map((record) => ({ ...record, value: Number(record.value.toPrecision(4)), machine }))];
records.sort((a, b) => subject(a).localeCompare(subject(b), "en", { numeric: true }));
writeFileSync(RESULTS, `[\n${records.map((record) => JSON.stringify(record)).join(",\n")}\n]\n`);
