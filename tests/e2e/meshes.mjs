import assert from "node:assert/strict";

/** Tolerance for the rounding of the networks' native and wasm builds. */
const SAME_MM = 1e-3;

/** The landmarks are the first vertices of every mesh. */
export const LANDMARKS = 468;
/** Vertices of the finest mesh that the page shows. */
export const DENSEST = 28_881;

/** Displacement of a vertex from one mesh to another, in the meshes' unit. */
export function displacement(from, to, vertex) {
  return to.positions[vertex].map((place, axis) => place - from.positions[vertex][axis]);
}

/** Maximum displacement of a vertex between two meshes. */
export function maxDisplacement(one, other) {
  return Math.max(...one.positions.map((_, vertex) => Math.hypot(...displacement(one, other, vertex))));
}

/**
 * Asserts that the page's mesh equals the command line's. Colours are compared at the landmarks only, because rounding
 * moves a few other vertices across a pixel border.
 */
export function assertSameMesh(seen, wanted) {
  assertSameShape(seen, wanted);
  for (const [vertex, colour] of seen.colours.slice(0, LANDMARKS).entries()) assert.deepEqual(colour, wanted.colours[vertex]);
}

/**
 * Asserts that a mesh was restored from a file. Colours are compared at the landmarks only, because the file holds the
 * photo as JPEG or not at all.
 */
export function assertRestored({ colours: come, ...seen }, { colours: had, ...wanted }) {
  assert.deepEqual(seen, wanted);
  assert.deepEqual(come.slice(0, LANDMARKS), had.slice(0, LANDMARKS));
  assert.equal(come.length, had.length);
}

/** Asserts that the page's mesh has the command line's shape. */
export function assertSameShape(seen, wanted) {
  assert.equal(seen.units, wanted.units);
  assert.deepEqual(seen.triangles, wanted.triangles);
  assert.equal(seen.positions.length, wanted.positions.length);
  const apart_mm = maxDisplacement(seen, wanted);
  assert.ok(apart_mm < SAME_MM, `a vertex is ${apart_mm} mm away from the command line's`);
}
