// Meshes as what they are wherever they are stored: places, and the triangles that join them.

/** @typedef {[number, number, number]} Point */
/** @typedef {{ positions: Point[], triangles: Point[] }} Mesh */

/** Two places closer than this are one: a hundredth of the shortest edge, and more than any format rounds off. */
const SAME_M = 2e-6;

/** Points are looked for in cubes of this side, and in the next one only near a border: wide beside SAME_M, narrow beside an edge. */
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

  /** The number of the place at a point; -1 where none is. @param {Point} point */
  at(point) {
    const [xs, ys, zs] = point.map(cellsNear);
    for (const x of xs) {
      for (const y of ys) {
        for (const z of zs) {
          const found = this.#cells.get(key(x, y, z))?.find((place) => near(this.list[place], point));
          if (found !== undefined) return found;
        }
      }
    }
    return -1;
  }

  /** The number of the place at a point, a new one where none was. @param {Point} point */
  put(point) {
    const found = this.at(point);
    if (found >= 0) return found;
    const [x, y, z] = point.map((value) => Math.floor(value / CELL_M));
    const cell = key(x, y, z);
    this.#cells.set(cell, [...(this.#cells.get(cell) ?? []), this.list.length]);
    return this.list.push(point) - 1;
  }
}

/** Triangles by the places they join. @param {number[][]} triangles */
export function oriented(triangles) {
  return new Set(triangles.map(turned));
}

/** A triangle by the places it joins, whichever corner is named first; turned over, it is another. @param {number[]} corners */
export function turned(corners) {
  const first = corners.indexOf(Math.min(...corners));
  return [0, 1, 2].map((step) => corners[(first + step) % 3]).join(",");
}

/** Edges that are not passed once in each direction: none where a surface is closed and of one orientation. @param {number[][]} triangles */
export function openEdges(triangles) {
  /** @type {Map<string, number[]>} */
  const passed = new Map();
  for (const [a, b, c] of triangles) {
    for (const [from, to] of [[a, b], [b, c], [c, a]]) {
      const edge = `${Math.min(from, to)},${Math.max(from, to)}`;
      passed.set(edge, [...(passed.get(edge) ?? []), from < to ? 1 : -1]);
    }
  }
  return [...passed.values()].filter((ways) => ways.length !== 2 || ways[0] + ways[1] !== 0).length;
}

/** What a closed surface encloses, by the divergence theorem; negative where it is inside out. @param {Mesh} mesh */
export function volume({ positions, triangles }) {
  const six = triangles.map((corners) => determinant(...corners.map((corner) => positions[corner])));
  return six.reduce((sum, part) => sum + part, 0) / 6;
}

/** How long, high and deep points are. @param {Point[]} points @returns {Point} */
export function size(points) {
  return [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
  });
}

/** @param {Point} a @param {Point} b @param {Point} c */
function determinant(a, b, c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/** Along one axis, the cubes in which a place may be that is as good as at a coordinate. @param {number} value m */
function cellsNear(value) {
  const [least, most] = [Math.floor((value - SAME_M) / CELL_M), Math.floor((value + SAME_M) / CELL_M)];
  return least === most ? [least] : [least, most];
}

/** One number for a cube; two cubes that share one are told apart by their places. @param {number} x @param {number} y @param {number} z */
function key(x, y, z) {
  return (x * 0x10000 + y) * 0x10000 + z;
}

/** @param {Point} a @param {Point} b */
function near(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < SAME_M;
}
