// Verifies that a reader's report matches the mesh that the file was made from: positions, triangles and colours.
import assert from "node:assert/strict";
import { Places, openEdges, oriented, volume } from "./shape.mjs";
import { METRES, MOVED } from "./table.mjs";

/** @typedef {import("./shape.mjs").Point} Point */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A reader's report about a file. Readers omit properties that they do not support.
 *
 * @typedef {object} Report
 * @property {string} [error] why the file could not be read
 * @property {string[]} [remarks] warnings and errors
 * @property {Point[]} [positions] in the file's unit, morph targets applied at their weights
 * @property {Point[]} [triangles] indices of positions, counter-clockwise from outside
 * @property {[number, number][]} [uvs]
 * @property {{ width: number, height: number }} [texture] decoded, px
 * @property {Point[]} [vertex_colours] colour of each vertex, sRGB from 0 to 255
 * @property {Point[][]} [corner_colours] alternatively, of each triangle corner
 * @property {[name: string | null, weight: number][]} [morphs]
 * @property {number} [unit_m] the file's unit, as the file states it
 * @property {string} [up] the file's upward axis
 * @property {boolean} [closed] whether the reader considers it a closed, outward-oriented body
 * @property {number} [volume] the reader's volume of that body, in the file's unit
 * @property {boolean} [unlit]
 * @property {Point} [size] in metres
 * @property {number} [colours] number of colours in the reader's rendering
 */

/** The shape a file is made from, in metres. @typedef {{ places: Places, triangles: Set<string>, colours: Point[], size: Point }} Truth */

/**
 * Largest mean colour error over all vertices, of 255. Vertex colours are bytes in each format. A texture is a JPEG of the same
 * photo, sampled at the nearest pixel without interpolation.
 */
const MAX_OFF = { colours: 0.6, photo: 5, whole: 14 };
/** Relative: rounding to eight digits, and sums in 32 bits. */
const SAME_VOLUME = 1e-4;
const SAME_SIZE_M = 1e-6;
/** The command line's note about creases that are too narrow for a wall. */
const ROUNDED = /\bby up to ([\d.]+) mm/;
/** Share of the face's triangles that may be smoothed, at lips, lids and nostrils. */
const MAX_ROUNDED = 0.15;
/** Half of the last digit of the command line's mm and cm³, plus a margin. */
const HALF_DIGIT = 0.051;
/** Greatest depth of a carved eye, m, and the corners of both eyes. */
const CARVED_M = 0.006;
const EYES = [[33, 133], [263, 362]];
/** Triangles of the canonical face that fill eyes and mouth. */
const FILLINGS = 898 - 852;
const BODY_CM3 = /([\d.]+) cm³/;
/** Of 4096 colours; an empty rendering has one. */
const MIN_COLOURS = 40;

/** Ground truth from a shape's JSON, in mm. @param {{ positions: Point[], triangles: Point[], colours: Point[] }} json @returns {Truth} */
export function truthOf({ positions, triangles, colours }) {
  const points = positions.map((point) => point.map((value) => value / 1000));
  const places = new Places(points);
  if (points.some((point, at) => places.at(point) !== at)) throw new Error("two vertices of the mesh coincide");
  const size = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  return { places, triangles: new Set(triangles.map(oriented)), colours, size };
}

/** Asserts that a report matches the truth. @param {Row} row @param {Truth} truth @param {Report} report @param {string} printed by the command line */
export function verify(row, truth, report, printed) {
  const meant = Object.entries(row.morphs ?? {});
  const { error, remarks = [], morphs = meant, up = "Y", unlit = false } = report;
  const listed = (all) => all.map(([name, weight]) => `${name} at ${weight.toFixed(4)}`).sort();
  assert.deepEqual(
    { error, remarks, morphs: listed(morphs), up, unlit },
    { error: undefined, remarks: [], morphs: listed(meant), up: "Y", unlit: false },
  );

  const metres = METRES[row.ending] ?? 1;
  const { unit_m = metres, size = truth.size, uvs = [], colours = MIN_COLOURS } = report;
  assert.ok(near(unit_m / metres, 1, 1e-9), `unit ${unit_m} m, not ${metres}`);
  assert.ok(size.every((length, axis) => near(length, truth.size[axis], SAME_SIZE_M)), `size ${size} m, not ${truth.size}`);
  assert.ok(uvs.flat().every((value) => value >= 0 && value <= 1), "texture coordinates outside 0 to 1");
  assert.ok(colours >= MIN_COLOURS, `a rendering with ${colours} colours`);
  if (report.positions) verifyMesh(row, truth, report, printed);
}

function verifyMesh(row, truth, report, printed) {
  const points = pointsOf(row, truth, report);
  const known = points.map((point) => truth.places.at(point));
  const faces = new Set(report.triangles.map((corners) => oriented(corners.map((corner) => known[corner]))));
  const lost = [...truth.triangles].filter((triangle) => !faces.has(triangle)).length;
  assert.ok(lost <= mayBeLost(row, truth, printed), `${lost} of the face's ${truth.triangles.size} triangles missing or flipped`);
  if (row.body) {
    verifyBody(row, points, report, printed);
    verifyRounding(known, points, truth, printed);
  } else if (!row.eyesAndMouth) {
    assert.equal(report.triangles.length, truth.triangles.size, "triangles");
    assert.equal(known.filter((place) => place < 0).length, 0, "vertices that the face does not have");
  }
  for (const axis of MOVED[row.ending] ?? []) {
    const lowest = report.positions.reduce((least, point) => (point[axis] < least[axis] ? point : least));
    const lowest_m = lowest[axis] * (METRES[row.ending] ?? 1);
    assert.ok(near(lowest_m, 0, SAME_SIZE_M), `starts at ${lowest_m} m, not 0, along ${"XYZ"[axis]}`);
  }
  if (row.baseColour !== "none") verifyColours(row, truth, report, known);
}

/** Positions in metres in the model's frame. Undoes a format's translation by aligning the tip of the nose, the frontmost point. */
function pointsOf({ ending }, truth, { positions }) {
  const scale = METRES[ending] ?? 1;
  const points = positions.map((point) => point.map((value) => value * scale));
  if (!(ending in MOVED)) return points;
  const [tip, meant] = [points, truth.places.list].map((all) => all.reduce((most, point) => (point[2] > most[2] ? point : most)));
  return points.map((point) => point.map((value, axis) => value - tip[axis] + meant[axis]));
}

/** Number of the face's triangles that may be missing: replaced fillings of eyes and mouth, carved eyes, or smoothed creases. */
function mayBeLost({ shape, body, eyesAndMouth }, truth, printed) {
  const fillings = eyesAndMouth || body ? FILLINGS * 4 ** shape.density : 0;
  return fillings + (body && ROUNDED.test(printed) ? MAX_ROUNDED * truth.triangles.size : 0);
}

/** Asserts a closed, outward body in one piece of genus 0, also according to the reader, with the command line's volume. */
function verifyBody({ ending }, points, { triangles, closed = true, volume: theirs, unit_m = METRES[ending] ?? 1 }, printed) {
  const places = points.map(String);
  const characteristic = new Set(places).size - triangles.length / 2;
  const enclosed_m3 = volume(points, triangles);
  const printed_cm3 = Number(BODY_CM3.exec(printed)?.[1]);
  assert.equal(openEdges(triangles.map((corners) => corners.map((corner) => places[corner]))), 0, "edges open or flipped");
  assert.equal(characteristic, 2, "vertices − edges + triangles");
  assert.ok(enclosed_m3 > 0, "inside out");
  assert.ok(closed, "not closed according to the reader");
  const theirs_m3 = theirs === undefined ? enclosed_m3 : theirs * unit_m ** 3;
  assert.ok(near(theirs_m3 / enclosed_m3, 1, SAME_VOLUME), `${theirs_m3} m³ according to the reader, not ${enclosed_m3}`);
  assert.ok(near(printed_cm3, 1e6 * enclosed_m3, HALF_DIGIT), `${printed_cm3} cm³ according to the command line, not ${1e6 * enclosed_m3}`);
}

/** Asserts that the body has a vertex within the reported distance of each vertex of the face, or behind it in carved eyes. */
function verifyRounding(known, points, truth, printed) {
  const most_m = (Number(ROUNDED.exec(printed)?.[1] ?? 0) + HALF_DIGIT) / 1000;
  const kept = new Set(known);
  const lost = truth.places.list.filter((_, place) => !kept.has(place));
  const far = lost.filter(([x, y, z]) => {
    const depth_m = isInEye([x, y], truth) ? CARVED_M : 0;
    return points.every((point) => Math.hypot(point[0] - x, point[1] - y, Math.max(0, z - point[2] - depth_m, point[2] - z)) > most_m);
  });
  assert.equal(far.length, 0, "vertices of the face that are further away than the command line reports");
}

/** Whether a position, seen from the front, is between the corners of an eye. */
function isInEye([x, y], truth) {
  return EYES.some((corners) => {
    const [outer, inner] = corners.map((corner) => truth.places.list[corner]);
    const middle = [(outer[0] + inner[0]) / 2, (outer[1] + inner[1]) / 2];
    return Math.hypot(x - middle[0], y - middle[1]) < Math.hypot(outer[0] - inner[0], outer[1] - inner[1]) / 2;
  });
}

/** Asserts the mean colour error over the corners of the face's triangles; ignores a body's sides and back. */
function verifyColours({ baseColour }, truth, { triangles, vertex_colours, corner_colours }, known) {
  const offs = triangles.flatMap((corners, at) => {
    if (!truth.triangles.has(oriented(corners.map((corner) => known[corner])))) return [];
    return corners.flatMap((corner, step) => {
      const shown = corner_colours?.[at][step] ?? vertex_colours?.[corner];
      return truth.colours[known[corner]].map((value, channel) => Math.abs(value - (shown?.[channel] ?? Number.NaN)));
    });
  });
  const off = offs.reduce((sum, each) => sum + each, 0) / offs.length;
  assert.ok(off < MAX_OFF[baseColour], `mean colour error ${off} of 255; at most ${MAX_OFF[baseColour]}`);
}

/** Also false for NaN. */
function near(a, b, distance) {
  return Math.abs(a - b) < distance;
}
