// Has every file of the table opened by every program that is not ours, and counts: node tests/readers/run.mjs [READER…].
// Each reader of each file is a test; so is each combination of a GLB's choices before Khronos' validator. What was seen goes
// to target/readers/tables.md.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";
import { validateGlb } from "../journeys/validate-glb.mjs";
import { breaches } from "./breaches.mjs";
import { FOLDER, makeRoom, shapeAsJson, written } from "./files.mjs";
import { findings, truthOf } from "./judge.mjs";
import { Missing } from "./missing.mjs";
import { onThePhoto } from "./on-the-photo.mjs";
import { BLENDER } from "./python.mjs";
import { READERS } from "./readers.mjs";
import { tables } from "./tables.mjs";
import { MATRIX, ROWS } from "./table.mjs";

/** Where every reader has to be had. */
const HAS_ALL = process.env.CI === "true";

const wanted = process.argv.slice(2);
const counts = { passed: 0, failed: 0 };
/** @type {Map<string, Promise<import("./judge.mjs").Truth>>} */
const truths = new Map();

for (const { name, findings: found } of breaches()) tell(name, found);
await makeRoom();
const files = await timed("files", () => filesOf(ROWS));
const readers = [];
for (const reader of READERS.filter(isAsked)) readers.push(await timed(reader.name, () => opened(reader)));
compareTextures();
const matrix = isWanted("validator") ? await timed("validator", validated) : [];
const photos = isWanted("photo") ? await timed("photo", () => seenOnThePhoto()) : [];
const known = await Promise.all(files.map(async (file) => ({ ...file, truth: await truth(file.row) })));
await writeFile(path.join(FOLDER, "tables.md"), tables({ files: known, readers, matrix, photos }));
console.log(`readers: ${counts.passed} passed, ${counts.failed} failed`);
process.exitCode = counts.failed === 0 && counts.passed > 0 ? 0 : 1;

/** The files of rows; one that the command line refuses to write is a failure. @param {import("./table.mjs").Row[]} rows */
async function filesOf(rows) {
  const all = await written(rows);
  for (const { path: file, said, refused } of all) if (refused) tell(path.basename(file), [said]);
  return all.filter(({ refused }) => !refused);
}

/** All files that a reader knows of, each judged. @param {import("./readers.mjs").Reader} reader */
async function opened(reader) {
  const known = files.filter(({ row }) => reader.opens.includes(row.ending) && (reader.knows?.(row) ?? true));
  try {
    const seen = known.length > 0 ? await reader.read(known.map((file) => file.path)) : [];
    if (seen.length !== known.length) throw new Error(`${reader.name} told of ${seen.length} files of ${known.length}`);
    for (const [at, { row, path: file, said }] of known.entries()) {
      const asked = reader.blind?.(row) ? { ...row, skin: /** @type {const} */ ("none") } : row;
      tell(`${reader.name}, ${path.basename(file)}`, findings(asked, await truth(row), seen[at], said));
    }
    return { reader, files: known, seen };
  } catch (error) {
    if (!(error instanceof Missing)) throw error;
    if (HAS_ALL) tell(reader.name, [error.message]);
    else console.log(`– ${reader.name} is left out: ${error.message}`);
    return { reader, files: [], seen: [], missing: error.message };
  }
}

/** What a picture measures is the same to all who decode it. */
function compareTextures() {
  for (const { path: file } of files) {
    const seen = readers.flatMap((opened) => opened.seen.filter((one) => one.path === file && one.texture));
    const sizes = new Set(seen.map(({ texture }) => `${texture.width} × ${texture.height}`));
    if (seen.length > 1) tell(`${path.basename(file)}, its texture`, sizes.size === 1 ? [] : [`it measures ${[...sizes].join(" or ")} px`]);
  }
}

/** Every combination of what can be chosen about a GLB, with the validator's counts of errors, warnings, remarks and hints. */
async function validated() {
  const all = [];
  for (const file of await filesOf(MATRIX)) {
    const verdict = await validateGlb(new Uint8Array(await readFile(file.path)));
    tell(`validator, ${path.basename(file.path)}`, verdict.clean ? [] : verdict.messages);
    all.push({ ...file, counts: verdict.counts });
  }
  return all;
}

async function seenOnThePhoto() {
  const all = await onThePhoto();
  for (const { name, findings: found } of all) tell(`on the photo, ${name}`, found);
  return all;
}

/** The shape of a row, read once. @param {import("./table.mjs").Row} row */
function truth({ shape }) {
  const key = JSON.stringify(shape);
  const reading = truths.get(key) ?? shapeAsJson(shape).then(truthOf);
  truths.set(key, reading);
  return reading;
}

/** @param {string} name @param {string[]} found */
function tell(name, found) {
  counts[found.length === 0 ? "passed" : "failed"] += 1;
  if (found.length > 0) console.log([`✗ ${name}`, ...found].join("\n    "));
}

/** Blender takes more room than all the others together, and is asked only where it is named. @param {import("./readers.mjs").Reader} reader */
function isAsked({ name }) {
  return isWanted(name) && (name !== "Blender" || process.env[BLENDER] !== undefined);
}

/** @param {string} name */
function isWanted(name) {
  return wanted.length === 0 || wanted.includes(name);
}

/** @template T @param {string} name @param {() => Promise<T>} work */
async function timed(name, work) {
  const started = performance.now();
  const done = await work();
  console.log(`  ${name}: ${((performance.now() - started) / 1000).toFixed(1)} s`);
  return done;
}
