import { execFile } from "node:child_process";
import { readFile } from "node:fs/promises";
import { promisify } from "node:util";
import { PNG } from "pngjs";

/** What the printer lays down, by what the slicer calls it. @type {Record<string, number[]>} */
const COLOURS = { "External perimeter": [224, 122, 62], "Overhang perimeter": [190, 60, 90], Perimeter: [240, 190, 120] };
const OTHERS = [120, 150, 190];
const GROUND = [245, 243, 239];

const PX_PER_MM = 4;
/** How far up the slices are, as shares of the height. */
const SHARES = [0.1, 0.35, 0.55, 0.75, 0.92];

/** @typedef {{ type: string, from: number[], to: number[] }} Stroke where plastic is laid down, mm */
/** @typedef {{ z_mm: number, strokes: Stroke[] }} Layer */

/** Layers of a body as PrusaSlicer plans them, and all of them seen from the front of the printer. @param {string} stl */
export async function slicesOf(stl) {
  const plan = `${stl}.gcode`;
  const print = ["--layer-height", "0.2", "--nozzle-diameter", "0.4", "--filament-diameter", "1.75", "--skirts", "0"];
  await promisify(execFile)("prusa-slicer", ["--export-gcode", ...print, "--output", plan, stl]);
  const layers = layersOf(await readFile(plan, "utf8"));
  const top_mm = layers.at(-1)?.z_mm ?? 0;
  const slices = SHARES.map((share) => layers.find((layer) => layer.z_mm >= share * top_mm) ?? layers[0]);
  const fromAbove = (/** @type {number[]} */ [x, y]) => [x, -y];
  const cells = slices.map((layer) => ({ picture: drawn([layer], fromAbove, layers), caption: `The layer at ${layer.z_mm.toFixed(1)} mm` }));
  const some = layers.filter((_, at) => at % 4 === 0);
  const beside = { picture: drawn(some, ([x, , z]) => [x, -z], layers), caption: `${layers.length} layers from beside, every fourth` };
  return [...cells, beside];
}

/** @param {string} plan G-code with PrusaSlicer's comments @returns {Layer[]} */
function layersOf(plan) {
  /** @type {Layer[]} */
  const layers = [];
  let [type, place] = ["", [0, 0]];
  for (const line of plan.split("\n")) {
    if (line.startsWith(";Z:")) layers.push({ z_mm: Number(line.slice(3)), strokes: [] });
    if (line.startsWith(";TYPE:")) type = line.slice(6);
    const move = /^G1 X(\S+) Y(\S+)( E[\d.]+)?/.exec(line);
    if (!move) continue;
    const to = [Number(move[1]), Number(move[2])];
    if (move[3] && type !== "Skirt/Brim") layers.at(-1)?.strokes.push({ type, from: place, to });
    place = to;
  }
  return layers.filter((layer) => layer.strokes.length > 0);
}

/**
 * Layers in a picture with room for all.
 *
 * @param {Layer[]} layers
 * @param {(place: number[]) => number[]} seen where a place is in the picture, mm
 * @param {Layer[]} all
 */
function drawn(layers, seen, all) {
  const strokesOf = (/** @type {Layer[]} */ of) =>
    of.flatMap(({ z_mm, strokes }) => strokes.map(({ type, from, to }) => ({ type, ends: [from, to].map(([x, y]) => seen([x, y, z_mm])) })));
  const [strokes, places] = [strokesOf(layers), strokesOf(all).flatMap(({ ends }) => ends)];
  const ends = [0, 1].map((axis) => places.reduce(([low, high], place) => [Math.min(low, place[axis]), Math.max(high, place[axis])], [Infinity, -Infinity]));
  const [width, height] = ends.map(([low, high]) => Math.ceil((high - low + 4) * PX_PER_MM));
  const picture = new PNG({ width, height });
  for (let at = 0; at < picture.data.length; at += 4) picture.data.set([...GROUND, 255], at);
  for (const { type, ends: stroke } of strokes) {
    const [from, to] = stroke.map((place) => place.map((value, axis) => (value - ends[axis][0] + 2) * PX_PER_MM));
    lay(picture, from, to, COLOURS[type] ?? OTHERS);
  }
  return PNG.sync.write(picture);
}

/** @param {PNG} picture @param {number[]} from @param {number[]} to @param {number[]} colour */
function lay(picture, from, to, colour) {
  const steps = Math.ceil(Math.max(Math.abs(to[0] - from[0]), Math.abs(to[1] - from[1]), 1));
  for (let step = 0; step <= steps; step++) {
    const [x, y] = from.map((value, axis) => Math.round(value + ((to[axis] - value) * step) / steps));
    for (const [right, down] of [[0, 0], [1, 0], [0, 1], [1, 1]]) picture.data.set([...colour, 255], 4 * ((y + down) * picture.width + x + right));
  }
}
