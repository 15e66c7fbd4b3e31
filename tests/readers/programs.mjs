// The readers that are programs of their own: scripts in Python, and PrusaSlicer without a window.
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";

/** @typedef {import("./judge.mjs").Seen} Seen */

/** The positions of many thousand vertices as text. */
const MOST_BYTES = 1 << 30;
const SLICER = "prusa-slicer";
const SLICER_LIMIT_MS = 120_000;
/** A usual printer and PLA. */
const PRINT = ["--layer-height", "0.2", "--nozzle-diameter", "0.4", "--filament-diameter", "1.75", "--filament-density", "1.24"];
/** PrusaSlicer's counts of repairs; it lists only those it made. */
const REPAIRS = /^(?:degenerate_facets|edges_fixed|facets_removed|facets_reversed|backwards_edges|open_edges) *= *\d+/gm;
const COMPLAINTS = /^.*\b(?:warning|error|repair|not manifold|empty layer)\b.*$/gim;

const run = promisify(execFile);

/** The reason why a program is not on this machine. */
export class Missing extends Error {}

/**
 * One process for all files.
 *
 * @param {string} reader the script's name after `with_`
 * @param {string} [variable] names the environment variable with the interpreter
 * @returns {(files: string[]) => Promise<Seen[]>}
 */
export function python(reader, variable = "ROSTO_READERS_PYTHON") {
  return async (files) => {
    const interpreter = process.env[variable];
    if (!interpreter) throw new Missing(`${variable} names no Python`);
    const script = path.join(import.meta.dirname, `python/with_${reader}.py`);
    const { stdout } = await run(interpreter, [script, ...files], { maxBuffer: MOST_BYTES }).catch((error) => {
      const lacking = /ModuleNotFoundError: (.+)/.exec(error.stderr ?? "");
      throw lacking ? new Missing(lacking[1]) : error;
    });
    // Libraries print lines of their own.
    return stdout.split("\n").filter((line) => line.startsWith('{"path"')).map((line) => JSON.parse(line));
  };
}

/** PrusaSlicer's measurements and repairs of bodies, and its complaints while it slices them. @param {string[]} files */
export async function slice(files) {
  await run(SLICER, ["--help"]).catch(() => {
    throw new Missing(`no \`${SLICER}\` here`);
  });
  /** @type {Seen[]} */
  const seen = [];
  for (const file of files) seen.push({ path: file, ...(await sliced(file).catch((error) => ({ error: String(error?.stderr || error) }))) });
  return seen;
}

/** @param {string} file @returns {Promise<Partial<Seen>>} */
async function sliced(file) {
  const options = { timeout: SLICER_LIMIT_MS, maxBuffer: MOST_BYTES };
  const { stdout: info } = await run(SLICER, ["--info", file], options);
  const gcode = `${file}.gcode`;
  const { stdout, stderr } = await run(SLICER, ["--export-gcode", ...PRINT, "--output", gcode, file], options);
  const hasLayers = (await readFile(gcode, "utf8")).includes("\n;LAYER_CHANGE");
  const parts = valueIn(info, "number_of_parts");
  return {
    closed: valueIn(info, "manifold") === "yes",
    volume: Number(valueIn(info, "volume")),
    remarks: [
      ...(info.match(REPAIRS) ?? []),
      ...((stderr + stdout).match(COMPLAINTS) ?? []),
      ...(parts === "1" ? [] : [`${parts} parts`]),
      ...(hasLayers ? [] : ["no layers"]),
    ],
  };
}

/** @param {string} info @param {string} name */
function valueIn(info, name) {
  return new RegExp(`^${name} *= *(\\S+)`, "m").exec(info)?.[1];
}
