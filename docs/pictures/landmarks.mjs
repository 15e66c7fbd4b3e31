// The map of the landmarks, drawn from the tables of the crate `face`.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";

/** @typedef {{ x: number, y: number }} Point px, y down */
/** @typedef {Point & { width: number, height: number }} Box px; x and y are those of its centre */

const SOURCES = path.resolve(import.meta.dirname, "../../crates/face/src");
const SIZE = { width: 800, height: 930 };
const PX_PER_CM = 50;
/** The height at which the canonical face's origin is drawn. */
const ORIGIN_Y = 434;
const DOT_PX = 1.9;
const FONT_PX = 11;
const DIGIT = { width: 6.2, height: 8.2 };
/** Distances between a dot and its number, px. */
const GAPS_PX = [3, 5];
const DIRECTIONS = 24;
/** A dot in less than this distance takes away a place for a number. */
const CROWDED_PX = 22;

/**
 * Writes an SVG of the canonical face from the front, with the number of each named landmark.
 *
 * @param {unknown} _browser
 * @param {string} file
 */
export async function drawLandmarks(_browser, file) {
  const [positions, midline, triangles, names] = await Promise.all([
    table("tables/positions.rs", "POSITIONS"),
    table("symmetry.rs", "MIDLINE"),
    table("tables/tessellation.rs", "TESSELLATION"),
    table("names/table.rs", "ANATOMICAL"),
  ]);
  const middle = new Set(midline.flat());
  const px = (/** @type {number} */ micro_cm) => micro_cm * 1e-6 * PX_PER_CM;
  const points = positions.map(([x, y]) => ({ x: SIZE.width / 2 + px(x), y: ORIGIN_Y - px(y) }));
  // The left landmarks follow in the order of their right partners.
  const rights = [...points.keys()].filter((landmark) => !middle.has(landmark));
  const leftOf = new Map(rights.map((right, index) => [right, points.length + index]));
  const lefts = rights.map((right) => ({ x: SIZE.width - points[right].x, y: points[right].y }));
  const named = names.flatMap(([landmark]) => [landmark, leftOf.get(landmark) ?? []].flat());
  await writeFile(file, svg([...points, ...lefts], triangles, named));
}

/** Rows of numbers of an array constant in Rust. @param {string} file @param {string} name @returns {Promise<number[][]>} */
async function table(file, name) {
  const source = await readFile(path.join(SOURCES, file), "utf8");
  const [, body] = new RegExp(`\\b${name}: [^=]*=\\s*\\[([^;]*)\\];`).exec(source) ?? [];
  if (!body) throw new Error(`${file} has no table ${name}`);
  const rows = body.match(/[([][^()[\]]*[)\]]/g) ?? [body];
  return rows.map((row) => (row.match(/-?\d+/g) ?? []).map(Number));
}

/** @param {Point[]} points @param {number[][]} triangles @param {number[]} named */
function svg(points, triangles, named) {
  const place = (/** @type {number} */ landmark) => `${rounded(points[landmark].x)} ${rounded(points[landmark].y)}`;
  const mesh = edgesOf(triangles).map(([a, b]) => `M${place(a)}L${place(b)}`);
  const dots = points.map(({ x, y }, landmark) => `<circle${named.includes(landmark) ? ' class="named"' : ""} cx="${rounded(x)}" cy="${rounded(y)}" r="${DOT_PX}"/>`);
  const numbers = [...labels(points, named)].map(([landmark, { x, y, height }]) => `<text x="${rounded(x)}" y="${rounded(y + height / 2)}">${landmark}</text>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE.width} ${SIZE.height}">
<style>
path { fill: none; stroke: #e3e0da; stroke-width: 0.7 }
circle { fill: #b3aea4 }
.named { fill: #b0480e }
text { font: ${FONT_PX}px Arial, "Liberation Sans", sans-serif; text-anchor: middle; fill: #26241f; stroke: #fff; stroke-width: 2; stroke-linejoin: round; paint-order: stroke }
.side { font-size: 13px; fill: #6b665c }
</style>
<rect width="100%" height="100%" fill="#fff"/>
<path d="${mesh.join("")}"/>
${dots.join("")}
${numbers.join("")}
<text class="side" x="70" y="24">subject’s right</text>
<text class="side" x="${SIZE.width - 70}" y="24">subject’s left</text>
</svg>
`;
}

/** The triangles' edges, each once. @param {number[][]} triangles */
function edgesOf(triangles) {
  const sides = triangles.flatMap(([a, b, c]) => [[a, b], [b, c], [c, a]]);
  return [...new Map(sides.map(([a, b]) => [`${Math.min(a, b)} ${Math.max(a, b)}`, [a, b]])).values()];
}

/** @param {number} px */
function rounded(px) {
  return Number(px.toFixed(1));
}

/** Places each number where it covers the fewest dots and numbers. @param {Point[]} points @param {number[]} named @returns {Map<number, Box>} */
function labels(points, named) {
  /** @type {Map<number, Box>} */
  const placed = new Map();
  const crowd = (/** @type {number} */ landmark) => points.filter(({ x, y }) => Math.hypot(x - points[landmark].x, y - points[landmark].y) < CROWDED_PX).length;
  // Crowded landmarks have the fewest places to choose from.
  for (const landmark of named.toSorted((a, b) => crowd(b) - crowd(a))) {
    const boxes = boxesNear(points[landmark], String(landmark).length);
    const costs = boxes.map((box) => cost(box, points, [...placed.values()]));
    placed.set(landmark, boxes[costs.indexOf(Math.min(...costs))]);
  }
  return placed;
}

/** Boxes for a number around its dot, the nearest first. @param {Point} dot @param {number} digits @returns {Box[]} */
function boxesNear(dot, digits) {
  const [width, height] = [digits * DIGIT.width, DIGIT.height];
  const box = (/** @type {number} */ gap, /** @type {number} */ angle) => {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const fromDot = gap + Math.min(width / 2 / Math.abs(cos), height / 2 / Math.abs(sin));
    return { x: dot.x + fromDot * cos, y: dot.y + fromDot * sin, width, height };
  };
  const angles = Array.from({ length: DIRECTIONS }, (_, index) => (2 * Math.PI * index) / DIRECTIONS);
  return GAPS_PX.flatMap((gap) => angles.map((angle) => box(gap, angle)));
}

/** @param {Box} box @param {Point[]} points @param {Box[]} others */
function cost(box, points, others) {
  const isOutside = Math.abs(box.x - SIZE.width / 2) + box.width / 2 > SIZE.width / 2 - 2;
  const dots = points.filter((point) => overlaps(box, { ...point, width: 2 * DOT_PX, height: 2 * DOT_PX }, 0));
  const numbers = others.filter((other) => overlaps(box, other, 1));
  return (isOutside ? 1000 : 0) + dots.length + 4 * numbers.length;
}

/** @param {Box} a @param {Box} b @param {number} margin px */
function overlaps(a, b, margin) {
  return Math.abs(a.x - b.x) < (a.width + b.width) / 2 + margin && Math.abs(a.y - b.y) < (a.height + b.height) / 2 + margin;
}
