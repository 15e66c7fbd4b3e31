// Files of the table's rows, exported by the command line.
import { execFile } from "node:child_process";
import { mkdir, readFile, rm } from "node:fs/promises";
import { availableParallelism } from "node:os";
import path from "node:path";
import { Readable } from "node:stream";
import { promisify } from "node:util";
import { program } from "../e2e/command-line.mjs";
import { commandOf } from "./table.mjs";

/** @typedef {import("./table.mjs").Row} Row */
/** A file and the command line's output about it. @typedef {{ row: Row, path: string, printed: string }} ExportedFile */

const ROOT = path.resolve(import.meta.dirname, "../..");
/** Photo of all files. */
export const SAMPLE = path.join(ROOT, "web/assets/sample.png");
/** Output folder. */
export const FOLDER = path.join(ROOT, "target/readers");

/** @type {Map<string, Promise<any>>} */
const shapes = new Map();

// Removes old files: a leftover texture next to an OBJ would hide a missing one.
await rm(FOLDER, { recursive: true, force: true });
await mkdir(FOLDER, { recursive: true });

/**
 * Exports the files of rows, one per core at a time; throws the command line's error if it refuses one.
 *
 * @param {Row[]} rows
 * @returns {Promise<ExportedFile[]>}
 */
export function exported(rows) {
  return Readable.from(rows).map(write, { concurrency: availableParallelism() }).toArray();
}

/** A shape in mm, from Rosto's JSON format. @param {Row["shape"]} shape */
export function shapeOf(shape) {
  const key = JSON.stringify(shape);
  const reading = shapes.get(key) ?? write({ ending: "json", shape, baseColour: "colours" }).then(({ path: file }) => readFile(file, "utf8")).then(JSON.parse);
  shapes.set(key, reading);
  return reading;
}

/** Names a file after its options, in characters that each reader accepts. @param {Row} row @returns {Promise<ExportedFile>} */
async function write(row) {
  const options = commandOf(row);
  const file = path.join(FOLDER, `${options.join(" ").slice(2).replaceAll(/[^\w.]+/g, "-")}.${row.ending}`);
  const { stdout, stderr } = await promisify(execFile)(program(), ["mesh", SAMPLE, "-o", file, ...options]);
  return { row, path: file, printed: `${stdout}${stderr}` };
}
