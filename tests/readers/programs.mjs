// Readers that are separate programs: Python scripts, and PrusaSlicer without a window.
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";

/** @typedef {import("./verifier.mjs").Report} Report */

/** For the positions of thousands of vertices as text. */
const MAX_BYTES = 1 << 30;
const SLICER = "prusa-slicer";
const SLICER_LIMIT_MS = 120_000;
/** Typical printer with PLA. */
const PRINT = ["--layer-height", "0.2", "--nozzle-diameter", "0.4", "--filament-diameter", "1.75", "--filament-density", "1.24"];
/** PrusaSlicer's repair counts, listed if they are not 0. */
const REPAIRS = ["degenerate_facets", "edges_fixed", "facets_removed", "facets_reversed", "backwards_edges", "open_edges"];
const COMPLAINTS = /^.*\b(?:warning|error|repair|not manifold|empty layer)\b.*$/gim;

const run = promisify(execFile);

/** Reason why a program is unavailable. */
export class Missing extends Error {}

/**
 * Starts one process for all files.
 *
 * @param {string} reader the script's name after `with_`
 * @param {string} [interpreter]
 */
export function python(reader, interpreter = process.env.ROSTO_READERS_PYTHON) {
  return async (/** @type {unknown} */ _, /** @type {string[]} */ files) => {
    if (!interpreter) throw new Missing("ROSTO_READERS_PYTHON is not set");
    const script = path.join(import.meta.dirname, `python/with_${reader}.py`);
    const { stdout } = await run(interpreter, [script, ...files], { maxBuffer: MAX_BYTES }).catch((error) => {
      const lacking = /ModuleNotFoundError: (.+)/.exec(error.stderr ?? "");
      throw lacking ? new Missing(lacking[1]) : error;
    });
    /** @type {Report[]} */
    const reports = stdout.trim().split("\n").map((line) => JSON.parse(line));
    return async (/** @type {string} */ file) => reports[files.indexOf(file)];
  };
}

/** PrusaSlicer's measurements, repairs and warnings for a body. */
export async function prusaSlicer() {
  await run(SLICER, ["--help"]).catch(() => {
    throw new Missing(`\`${SLICER}\` not found`);
  });
  return sliced;
}

/** @param {string} file @returns {Promise<Report>} */
async function sliced(file) {
  const options = { timeout: SLICER_LIMIT_MS, maxBuffer: MAX_BYTES };
  const { stdout: listed } = await run(SLICER, ["--info", file], options);
  const info = Object.fromEntries([...listed.matchAll(/^(\w+) *= *(\S+)/gm)].map(([, name, value]) => [name, value]));
  const gcode = `${file}.gcode`;
  const { stdout, stderr } = await run(SLICER, ["--export-gcode", ...PRINT, "--output", gcode, file], options);
  const hasLayers = (await readFile(gcode, "utf8")).includes("\n;LAYER_CHANGE");
  return {
    closed: info.manifold === "yes",
    volume: Number(info.volume),
    remarks: [
      ...REPAIRS.filter((repair) => repair in info).map((repair) => `${repair} = ${info[repair]}`),
      ...((stderr + stdout).match(COMPLAINTS) ?? []),
      ...(info.number_of_parts === "1" ? [] : [`${info.number_of_parts} parts`]),
      ...(hasLayers ? [] : ["no layers"]),
    ],
  };
}
