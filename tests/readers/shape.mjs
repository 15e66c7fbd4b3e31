// Compares meshes regardless of how vertices are stored: distinct places, and the triangles between them.
import { Matrix3 } from "three";

/** @typedef {[number, number, number]} Point */

/** Closer points coincide: 1 % of the shortest edge, and more than the formats' rounding. */
const SAME_M = 2e-6;
/** Cell size of the search grid: larger than SAME_M, smaller than an edge. */
const CELL_M = 6.4e-5;

/** Points in metres with a spatial index. */
export class Places {
  /** @type {Map<number, number[]>} */
  #cells = new Map();

  /** @param {Point[]} list */
  constructor(list) {
    this.list = list;
    for (const [place, point] of list.entries()) {
      const [cell] = cellsNear(point, 0);
      this.#cells.set(cell, [...(this.#cells.get(cell) ?? []), place]);
    }
  }

  /** Index of the place at a point; -1 if there is none. @param {Point} point */
  at(point) {
    const near = cellsNear(point, SAME_M).flatMap((cell) => this.#cells.get(cell) ?? []);
    return near.find((place) => Math.hypot(...point.map((value, axis) => value - this.list[place][axis])) < SAME_M) ?? -1;
  }
}

/** Key of an oriented triangle, independent of its first corner. @param {number[]} corners */
export function oriented(corners) {
  const first = corners.indexOf(Math.min(...corners));
  return [0, 1, 2].map((step) => corners[(first + step) % 3]).join(",");
}

/** Number of edges that are not used exactly once in each direction: 0 for a closed, oriented surface. @param {string[][]} triangles */
export function openEdges(triangles) {
  const edges = triangles.flatMap(([a, b, c]) => [[a, b], [b, c], [c, a]]);
  const used = new Set(edges.map(String));
  const unpaired = edges.filter(([from, to]) => from === to || !used.has(`${to},${from}`));
  return unpaired.length + edges.length - used.size;
}

/** Enclosed volume by the divergence theorem; negative if inside out. @param {Point[]} points @param {number[][]} triangles */
export function volume(points, triangles) {
  return triangles.reduce((sum, corners) => sum + new Matrix3(...corners.flatMap((corner) => points[corner])).determinant() / 6, 0);
}

/** Keys of the grid cells within a distance of a point; different cells may share a key. @param {Point} point @param {number} distance_m */
function cellsNear(point, distance_m) {
  const along = point.map((value) => [...new Set([value - distance_m, value + distance_m].map((end) => Math.floor(end / CELL_M)))]);
  return along.reduce((keys, cells) => keys.flatMap((key) => cells.map((cell) => key * 0x10000 + cell)), [0]);
}
