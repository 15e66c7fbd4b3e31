// Files of rows of the table, written by the command line.
import { execFile } from "node:child_process";
import { mkdir, readFile, rm } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { program } from "../journeys/command-line.mjs";
import { SAMPLE } from "../journeys/visitor.mjs";
import { inLanes } from "./lanes.mjs";
import { commandOf } from "./table.mjs";

/** @typedef {import("./table.mjs").Row} Row */
/** A file, and what the command line said about it or why it refused to write it. @typedef {{ row: Row, path: string, said: string, refused: boolean }} Written */

/** Everything that a run writes lies here. */
export const FOLDER = path.resolve(import.meta.dirname, "../../target/readers");

/** @type {Map<string, Promise<Written>>} */
const begun = new Map();

/** Empties the folder: what an earlier program wrote must not be what is read. */
export async function makeRoom() {
  await rm(FOLDER, { recursive: true, force: true });
  await mkdir(FOLDER, { recursive: true });
}

/** The files of rows, each written once. @param {Row[]} rows */
export function written(rows) {
  return inLanes(rows, file);
}

/** A shape in mm, in the one format that nobody but us reads. @param {Row["shape"]} shape */
export async function shapeAsJson(shape) {
  const { path: made, said, refused } = await file({ ending: "json", shape, options: [], skin: "colours" });
  if (refused) throw new Error(said);
  return JSON.parse(await readFile(made, "utf8"));
}

/** @param {Row} row */
function file(row) {
  const made = path.join(FOLDER, `${nameOf(row)}.${row.ending}`);
  const making = begun.get(made) ?? write(row, made);
  begun.set(made, making);
  return making;
}

/** @param {Row} row @param {string} to @returns {Promise<Written>} */
async function write(row, to) {
  const command = ["mesh", SAMPLE, "-o", to, ...commandOf(row)];
  const { stdout, stderr, refused } = await promisify(execFile)(program(), command).catch((error) => ({ ...error, refused: true }));
  return { row, path: to, said: `${stdout}${stderr}`, refused: refused === true };
}

/** What tells a row from all others of its format, in letters that every reader takes in a name. @param {Row} row */
function nameOf({ shape, options }) {
  const chosen = options.map((word) => word.replace(/^-+/, "").replaceAll(/[^a-z0-9.]+/g, "-"));
  return [shape.topology, shape.density, ...({ none: [], made: ["edited"], expressed: ["expressed"] })[shape.edits], ...chosen].join("-");
}
