// Pictures of models: expressions, textures next to the ground truth, layers of a printed body.
import { execFile } from "node:child_process";
import { mkdir, readdir, readFile } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { program } from "../../tests/e2e/command-line.mjs";
import { SAMPLE } from "../../tests/e2e/visitor.mjs";
import { cut, writeSheet } from "./sheet.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const DRAWN = path.join(ROOT, "target/pictures");
const TURNS = [0, 20, -20, 40, -40];
/** The head in each texture picture, px. */
const HEAD = { x: 194, y: 194, width: 635, height: 635 };

/** Colours of PrusaSlicer's extrusion types. @type {Record<string, string>} */
const COLOURS = { "External perimeter": "#e07a3e", "Overhang perimeter": "#be3c5a", Perimeter: "#f0be78" };
const OTHERS = "#7896be";
/** Heights of the layers shown, as shares of the body's height. */
const HEIGHTS = [0.1, 0.35, 0.55, 0.75, 0.92];

const run = promisify(execFile);

/** @param {import("@playwright/test").Browser} browser @param {string} file */
export async function drawExpressions(browser, file) {
  const folder = await drawnBy("expression_sheet");
  const names = (await readdir(folder)).sort();
  const cells = names.map(async (name) => ({ picture: await readFile(path.join(folder, name)), caption: name.slice(3, -4) }));
  await writeSheet(browser, file, await Promise.all(cells), { columns: 5, width: 270 });
}

/** For each turn: the photo, and the side that it hides as ground truth, with the photo projected, and with the whole texture. @param {import("@playwright/test").Browser} browser @param {string} file */
export async function drawTextures(browser, file) {
  const folder = await drawnBy("texture_sheet");
  const cell = async (/** @type {string} */ name, /** @type {string} */ caption) => ({ picture: cut(await readFile(path.join(folder, `${name}.png`)), HEAD), caption });
  const cells = TURNS.flatMap((turn) => {
    const hidden = turn > 0 ? "-45" : "45";
    return [
      cell(`photo${turn}`, `The photo, ${turn}°`),
      cell(`truthat${hidden}`, "From its hidden side"),
      cell(`projected${turn}at${hidden}`, "By the photo alone"),
      cell(`whole${turn}at${hidden}`, "By the whole texture"),
    ];
  });
  await writeSheet(browser, file, await Promise.all(cells), { columns: 4, width: 230 });
}

/** The sample portrait as a 2 mm mask, sliced by PrusaSlicer. @param {import("@playwright/test").Browser} browser @param {string} file */
export async function drawSlices(browser, file) {
  const [body, plan] = ["mask.stl", "mask.gcode"].map((name) => path.join(DRAWN, name));
  await mkdir(DRAWN, { recursive: true });
  await run(program(), ["mesh", SAMPLE, "-o", body, "--solid", "thickness:2"]);
  const print = ["--layer-height", "0.2", "--nozzle-diameter", "0.4", "--filament-diameter", "1.75", "--skirts", "0"];
  await run("prusa-slicer", ["--export-gcode", ...print, "--output", plan, body]);
  const layers = layersOf(await readFile(plan, "utf8"));
  const top_mm = layers.at(-1).z_mm;
  const shown = HEIGHTS.map((height) => layers.find(({ z_mm }) => z_mm >= height * top_mm));
  const cells = shown.map((layer) => ({ picture: svg([layer], ([x, y]) => [x, -y], layers), caption: `The layer at ${layer.z_mm.toFixed(1)} mm` }));
  const side = svg(layers.filter((_, at) => at % 4 === 0), ([x, , z]) => [x, -z]);
  await writeSheet(browser, file, [...cells, { picture: side, caption: `${layers.length} layers from the side, every fourth` }], { columns: 3, width: 300 });
}

/** Runs an example of `rosto-studio` and returns its output folder. @param {string} example */
async function drawnBy(example) {
  const folder = path.join(DRAWN, example);
  await run("cargo", ["run", "--quiet", "--release", "--locked", "--package", "rosto-studio", "--example", example, "--", folder], { cwd: ROOT });
  return folder;
}

/** @typedef {{ z_mm: number, lines: { type: string, from: number[], to: number[] }[] }} Layer */

/** @param {string} plan G-code with PrusaSlicer's comments @returns {Layer[]} */
function layersOf(plan) {
  /** @type {Layer[]} */
  const layers = [];
  let [type, from] = ["", [0, 0]];
  for (const line of plan.split("\n")) {
    if (line.startsWith(";Z:")) layers.push({ z_mm: Number(line.slice(3)), lines: [] });
    if (line.startsWith(";TYPE:")) type = line.slice(6);
    const [, x, y, extruded] = /^G1 X(\S+) Y(\S+)( E[\d.]+)?/.exec(line) ?? [];
    if (!x) continue;
    const to = [Number(x), Number(y)];
    if (extruded && type !== "Skirt/Brim") layers.at(-1).lines.push({ type, from, to });
    from = to;
  }
  return layers.filter(({ lines }) => lines.length > 0);
}

/** Draws `layers` in a view box that fits `all`. @param {Layer[]} layers @param {(place_mm: number[]) => number[]} seen projects into the picture, mm @param {Layer[]} all */
function svg(layers, seen, all = layers) {
  const projected = (/** @type {Layer[]} */ of) => of.flatMap(({ z_mm, lines }) => lines.map(({ type, from, to }) => ({ type, from: seen([...from, z_mm]), to: seen([...to, z_mm]) })));
  const drawn = projected(layers);
  const [xs, ys] = [0, 1].map((axis) => projected(all).map(({ to }) => to[axis]).sort((a, b) => a - b));
  const box = [xs[0] - 2, ys[0] - 2, xs.at(-1) - xs[0] + 4, ys.at(-1) - ys[0] + 4];
  const paths = drawn.map(({ type, from, to }) => `<path d="M${from} L${to}" stroke="${COLOURS[type] ?? OTHERS}" />`);
  return `<svg viewBox="${box.join(" ")}" width="${4 * box[2]}" stroke-width="0.45">${paths.join("")}</svg>`;
}
