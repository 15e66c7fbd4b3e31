import assert from "node:assert/strict";

/** The two compilations of the network's arithmetic round differently, by far less than this. */
const SAME_MM = 1e-3;

/** The landmarks are the first vertices of every mesh. */
export const LANDMARKS = 468;
/** Vertices of the finest mesh that the page shows. */
export const DENSEST = 28_881;

/** How far a vertex went from one mesh to another along each axis, in the meshes' unit. */
export function way(from, to, vertex) {
  return to.positions[vertex].map((place, axis) => place - from.positions[vertex][axis]);
}

/** The distance of the vertex that is furthest from where it is in the other mesh. */
export function furthest(one, other) {
  return Math.max(...one.positions.map((_, vertex) => Math.hypot(...way(one, other, vertex))));
}

/**
 * The page's mesh is the command line's. Between the landmarks, the same roundings give a few vertices, which lie on the border
 * between two pixels of the photo, the colour of the other one.
 */
export function assertSameMesh(seen, wanted) {
  assertSameShape(seen, wanted);
  for (const [vertex, colour] of seen.colors.slice(0, LANDMARKS).entries()) assert.deepEqual(colour, wanted.colors[vertex]);
}

/** A mesh that came back from a file that holds the photo as JPEG or not at all: between the landmarks, its colours are that one's. */
export function assertCameBack({ colors: come, ...seen }, { colors: had, ...wanted }) {
  assert.deepEqual(seen, wanted);
  assert.deepEqual(come.slice(0, LANDMARKS), had.slice(0, LANDMARKS));
  assert.equal(come.length, had.length);
}

/** The page's mesh has the command line's shape. */
export function assertSameShape(seen, wanted) {
  assert.equal(seen.units, wanted.units);
  assert.deepEqual(seen.triangles, wanted.triangles);
  assert.equal(seen.positions.length, wanted.positions.length);
  const apart_mm = furthest(seen, wanted);
  assert.ok(apart_mm < SAME_MM, `a vertex is ${apart_mm} mm away from the command line's`);
}
