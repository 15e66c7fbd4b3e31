// PrusaSlicer without a window: what it measures and mends on the way in, and the layers it makes.
import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { promisify } from "node:util";
import { inLanes } from "./lanes.mjs";
import { Missing } from "./missing.mjs";

const PROGRAM = "prusa-slicer";
const LIMIT_MS = 120_000;
/** A usual printer and PLA. */
const PRINT = ["--layer-height", "0.2", "--nozzle-diameter", "0.4", "--filament-diameter", "1.75", "--filament-density", "1.24"];

/** @typedef {import("./judge.mjs").Seen} Seen */

/** What it says it has mended; it names each only where there was something. */
const MENDED = /^(degenerate_facets|edges_fixed|facets_removed|facets_reversed|backwards_edges|open_edges) *= *(\d+)/gm;

/** @param {string[]} files @returns {Promise<Seen[]>} */
export async function slice(files) {
  const { stdout: help } = await run(["--help"]).catch(() => {
    throw new Missing(`no \`${PROGRAM}\` here`);
  });
  const version = /PrusaSlicer-([\d.]+)/.exec(help)?.[1] ?? "?";
  return inLanes(files, async (path) => {
    const seen = await sliced(path).catch((error) => ({ error: String(error?.stderr || error) }));
    return { reader: "PrusaSlicer", version, path, ...seen };
  });
}

async function sliced(path) {
  const { stdout: info } = await run(["--info", path]);
  const number = (/** @type {string} */ name) => Number(new RegExp(`^${name} *= *(\\S+)`, "m").exec(info)?.[1]);
  const mended = [...info.matchAll(MENDED)].map(([line]) => line);
  const parts = number("number_of_parts");
  const gcode = `${path}.gcode`;
  const layers = await run(["--export-gcode", ...PRINT, "--output", gcode, path]);
  const plan = await readFile(gcode, "utf8");
  const said = (/** @type {RegExp} */ wanted) => wanted.exec(plan)?.[1] ?? "";
  return {
    closed: /^manifold *= *yes/m.test(info),
    volume: number("volume"),
    sliced: {
      triangles: number("number_of_facets"),
      volume_mm3: number("volume"),
      filament_g: Number(said(/^; (?:total )?filament used \[g\] = (.+)$/m)),
      time: said(/^; estimated printing time \(normal mode\) = (.+)$/m),
      layers: plan.split(/^;LAYER_CHANGE/m).length - 1,
    },
    remarks: [...mended, ...(parts === 1 ? [] : [`${parts} parts`]), ...warnings(layers.stderr + layers.stdout)],
  };
}

/** What it objects to while it slices. @param {string} output */
function warnings(output) {
  return output.split("\n").filter((line) => /\b(warning|error|repair|not manifold|empty layer)\b/i.test(line));
}

/** @param {string[]} options */
function run(options) {
  return promisify(execFile)(PROGRAM, options, { timeout: LIMIT_MS, maxBuffer: 1 << 26 });
}
