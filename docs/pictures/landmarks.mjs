// The map of the landmarks, drawn from the tables of the crate `face`.
import { readFile, writeFile } from "node:fs/promises";
import path from "node:path";

/** @typedef {{ x: number, y: number }} Point px, y down */
/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box px */
/** @typedef {{ box: Box, anchor: Point, leader?: [Point, Point] }} Label */

const SOURCES = path.resolve(import.meta.dirname, "../../crates/face/src");
const SIZE = { width: 800, height: 930 };
const PX_PER_CM = 50;
/** Height of the canonical face's origin in the picture. */
const ORIGIN_Y = 434;
const DOT_PX = 1.9;
const FONT_PX = 9;
const DIGIT = { width: 5.1, height: 6.8 };
const DIRECTIONS = 24;
/** Distances from a dot to its number, px; from `LEADER_PX` on, a line joins the two. */
const GAPS_PX = [3, 5, 8, 12, 17, 23, 30, 38];
const LEADER_PX = 5;

/** Writes the canonical face from the front as an SVG, with the number of each named landmark. @param {unknown} _browser @param {string} file */
export async function drawLandmarks(_browser, file) {
  const [positions, midline, triangles, names] = await Promise.all([
    table("tables/positions.rs", "POSITIONS"),
    table("symmetry.rs", "MIDLINE"),
    table("tables/tessellation.rs", "TESSELLATION"),
    table("names/table.rs", "ANATOMICAL"),
  ]);
  const middle = new Set(midline.flat());
  const points = positions.map(([x, y]) => ({ x: SIZE.width / 2 + x * 1e-6 * PX_PER_CM, y: ORIGIN_Y - y * 1e-6 * PX_PER_CM }));
  // The left landmarks follow in the order of their right partners.
  const rights = [...points.keys()].filter((landmark) => !middle.has(landmark));
  const leftOf = new Map(rights.map((right, index) => [right, points.length + index]));
  const all = [...points, ...rights.map((right) => ({ x: SIZE.width - points[right].x, y: points[right].y }))];
  const named = names.flatMap(([landmark]) => (middle.has(landmark) ? [landmark] : [landmark, leftOf.get(landmark)]));
  await writeFile(file, svg(all, edgesOf(triangles), named));
}

/** The numbers in a constant array of Rust, one row for each innermost bracket. @param {string} file @param {string} name @returns {Promise<number[][]>} */
async function table(file, name) {
  const source = await readFile(path.join(SOURCES, file), "utf8");
  const [, body] = new RegExp(`\\b${name}: [^=]*=\\s*\\[([^;]*)\\];`).exec(source) ?? [];
  if (!body) throw new Error(`${file} has no table ${name}`);
  const rows = body.match(/[([][^()[\]]*[)\]]/g) ?? [body];
  return rows.map((row) => (row.match(/-?\d+/g) ?? []).map(Number));
}

/** @param {number[][]} triangles @returns {[number, number][]} each edge once */
function edgesOf(triangles) {
  /** @type {Map<string, [number, number]>} */
  const edges = new Map();
  for (const corners of triangles) {
    corners.forEach((a, index) => {
      const b = corners[(index + 1) % 3];
      edges.set(`${Math.min(a, b)} ${Math.max(a, b)}`, [a, b]);
    });
  }
  return [...edges.values()];
}

/** @param {Point[]} points @param {[number, number][]} edges @param {number[]} named */
function svg(points, edges, named) {
  const isNamed = new Set(named);
  const labels = placed(points, named);
  const place = (/** @type {Point} */ { x, y }) => `${rounded(x)} ${rounded(y)}`;
  const line = (/** @type {[Point, Point]} */ [a, b]) => `M${place(a)}L${place(b)}`;
  const mesh = edges.map(([a, b]) => line([points[a], points[b]])).join("");
  const leaders = labels.flatMap(({ leader }) => (leader ? [line(leader)] : [])).join("");
  const dot = ({ x, y }) => `<circle cx="${rounded(x)}" cy="${rounded(y)}" r="${DOT_PX}"/>`;
  const dots = (/** @type {boolean} */ wanted) => points.filter((_, landmark) => isNamed.has(landmark) === wanted).map(dot).join("");
  const numbers = labels.map(({ anchor: { x, y } }, index) => `<text x="${rounded(x)}" y="${rounded(y)}">${named[index]}</text>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${SIZE.width} ${SIZE.height}" font-family="Arial, 'Liberation Sans', sans-serif" font-size="${FONT_PX}" text-anchor="middle">
<rect width="100%" height="100%" fill="#fff"/>
<path d="${mesh}" stroke="#e3e0da" fill="none" stroke-width="0.7"/>
<g fill="#b3aea4">${dots(false)}</g>
<path d="${leaders}" stroke="#b0480e" fill="none" stroke-width="0.5"/>
<g fill="#b0480e">${dots(true)}</g>
<g fill="#26241f" stroke="#fff" stroke-width="2" stroke-linejoin="round" paint-order="stroke">${numbers.join("")}</g>
<g fill="#6b665c" font-size="13"><text x="70" y="24">subject’s right</text><text x="${SIZE.width - 70}" y="24">subject’s left</text></g>
</svg>
`;
}

/** @param {number} px */
function rounded(px) {
  return Number(px.toFixed(1));
}

/** Places the numbers one after the other, each where it covers the least of dots, numbers and leaders. @param {Point[]} points @param {number[]} named @returns {Label[]} */
function placed(points, named) {
  /** @type {Map<number, Label>} */
  const labels = new Map();
  // Crowded dots first, since they have the fewest free places.
  const crowd = (/** @type {number} */ landmark) => points.filter((point) => distance(point, points[landmark]) < 22).length;
  for (const landmark of named.toSorted((a, b) => crowd(b) - crowd(a))) {
    const candidates = candidatesFor(points[landmark], String(landmark).length);
    const costs = candidates.map((label, index) => index * 0.02 + cost(label, points, landmark, [...labels.values()]));
    labels.set(landmark, candidates[costs.indexOf(Math.min(...costs))]);
  }
  return named.map((landmark) => labels.get(landmark));
}

/** @param {Point} dot @param {number} digits @returns {Label[]} the nearest first */
function candidatesFor(dot, digits) {
  const [halfWidth, halfHeight] = [(digits * DIGIT.width) / 2, DIGIT.height / 2];
  return GAPS_PX.flatMap((gap) => Array.from({ length: DIRECTIONS }, (_, index) => {
    const angle = (2 * Math.PI * index) / DIRECTIONS;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    // The distance to the box's middle at which its edge is `gap` from the dot.
    const reach = gap + Math.min(halfWidth / Math.abs(cos), halfHeight / Math.abs(sin));
    const middle = { x: dot.x + reach * cos, y: dot.y + reach * sin };
    const box = { left: middle.x - halfWidth, top: middle.y - halfHeight, right: middle.x + halfWidth, bottom: middle.y + halfHeight };
    const anchor = { x: middle.x, y: middle.y + halfHeight };
    const end = { x: dot.x + gap * cos, y: dot.y + gap * sin };
    return gap < LEADER_PX ? { box, anchor } : { box, anchor, leader: /** @type {[Point, Point]} */ ([dot, end]) };
  }));
}

/** @param {Label} label @param {Point[]} points @param {number} landmark @param {Label[]} others */
function cost({ box, leader }, points, landmark, others) {
  const isOutside = box.left < 2 || box.top < 2 || box.right > SIZE.width - 2 || box.bottom > SIZE.height - 2;
  const dots = points.filter((point, index) => index !== landmark && (isWithin(point, box, DOT_PX) || (leader && fromLine(point, leader) < DOT_PX)));
  const hits = others.filter((other) => overlap(box, other.box) || crosses(leader, other.box) || crosses(other.leader, box) || meet(leader, other.leader));
  return (isOutside ? 1000 : 0) + 10 * dots.length + 40 * hits.length;
}

/** @param {Point} a @param {Point} b */
function distance(a, b) {
  return Math.hypot(a.x - b.x, a.y - b.y);
}

/** @param {Point} point @param {Box} box @param {number} margin */
function isWithin({ x, y }, box, margin) {
  return x > box.left - margin && x < box.right + margin && y > box.top - margin && y < box.bottom + margin;
}

/** @param {Box} a @param {Box} b */
function overlap(a, b) {
  return a.left < b.right + 1.5 && b.left < a.right + 1.5 && a.top < b.bottom + 1 && b.top < a.bottom + 1;
}

/** @param {Point} point @param {[Point, Point]} line */
function fromLine(point, [a, b]) {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const share = Math.max(0, Math.min(1, ((point.x - a.x) * dx + (point.y - a.y) * dy) / (dx * dx + dy * dy)));
  return distance(point, { x: a.x + share * dx, y: a.y + share * dy });
}

/** Whether a line, sampled, runs through a box. @param {[Point, Point] | undefined} line @param {Box} box */
function crosses(line, box) {
  if (!line) return false;
  const [a, b] = line;
  return Array.from({ length: 21 }, (_, i) => ({ x: a.x + ((b.x - a.x) * i) / 20, y: a.y + ((b.y - a.y) * i) / 20 })).some((point) => isWithin(point, box, 0.5));
}

/** Whether two lines cross. @param {[Point, Point] | undefined} one @param {[Point, Point] | undefined} other */
function meet(one, other) {
  if (!one || !other) return false;
  const side = (/** @type {Point[]} */ [a, b], /** @type {Point} */ c) => Math.sign((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  return side(one, other[0]) !== side(one, other[1]) && side(other, one[0]) !== side(other, one[1]);
}
