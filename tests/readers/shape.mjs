// Meshes however they are stored: distinct places, and the triangles that join them.

/** @typedef {[number, number, number]} Point */

/** Closer points are one place: a hundredth of the shortest edge, and more than any format's rounding. */
const SAME_M = 2e-6;
/** Side of the search grid's cells: wide compared with SAME_M, narrow compared with an edge. */
const CELL_M = 6.4e-5;

/** Points in metres, each place once. */
export class Places {
  /** @type {Map<number, number[]>} */
  #cells = new Map();
  /** @type {Point[]} */
  list = [];

  /** @param {Iterable<Point>} points */
  constructor(points = []) {
    for (const point of points) this.put(point);
  }

  /** Index of the place at a point; -1 if there is none. @param {Point} point */
  at(point) {
    for (const cell of cellsNear(point, SAME_M)) {
      const found = this.#cells.get(cell)?.find((place) => isSame(this.list[place], point));
      if (found !== undefined) return found;
    }
    return -1;
  }

  /** Index of the place at a point, added if there was none. @param {Point} point */
  put(point) {
    const found = this.at(point);
    if (found >= 0) return found;
    const [cell] = cellsNear(point, 0);
    this.#cells.set(cell, [...(this.#cells.get(cell) ?? []), this.list.length]);
    return this.list.push(point) - 1;
  }
}

/** A triangle as text, the same whichever corner comes first, another when flipped. @param {number[]} corners */
export function oriented(corners) {
  const first = corners.indexOf(Math.min(...corners));
  return [0, 1, 2].map((step) => corners[(first + step) % 3]).join(",");
}

/** Number of edges not used once in each direction: 0 for a closed, consistently oriented surface. @param {number[][]} triangles */
export function openEdges(triangles) {
  /** @type {Map<string, number[]>} */
  const uses = new Map();
  for (const [a, b, c] of triangles) {
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      const edge = `${Math.min(from, to)},${Math.max(from, to)}`;
      uses.set(edge, [...(uses.get(edge) ?? []), from < to ? 1 : -1]);
    }
  }
  return [...uses.values()].filter((ways) => ways.length !== 2 || ways[0] + ways[1] !== 0).length;
}

/** Enclosed volume by the divergence theorem, negative if inside out. @param {Point[]} points @param {number[][]} triangles */
export function volume(points, triangles) {
  return triangles.reduce((sum, [a, b, c]) => sum + determinant(points[a], points[b], points[c]) / 6, 0);
}

/** Extent along each axis. @param {Point[]} points */
export function size(points) {
  return [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  });
}

function determinant([ax, ay, az], [bx, by, bz], [cx, cy, cz]) {
  return ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
}

/** Keys of the cells within a distance of a point; cells may share a key. @param {Point} point @param {number} distance_m */
function cellsNear(point, distance_m) {
  const along = point.map((value) => [...new Set([value - distance_m, value + distance_m].map((end) => Math.floor(end / CELL_M)))]);
  return along.reduce((keys, cells) => keys.flatMap((key) => cells.map((cell) => key * 0x10000 + cell)), [0]);
}

/** @param {Point} a @param {Point} b */
function isSame(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < SAME_M;
}
