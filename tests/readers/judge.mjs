// Compares a reader's report with the mesh the file was made from: the same places, triangles and colours.
import assert from "node:assert/strict";
import { Places, openEdges, oriented, volume } from "./shape.mjs";
import { METRES, MOVED } from "./table.mjs";

/** @typedef {import("./shape.mjs").Point} Point */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A reader's report about a file; each leaves out the properties it does not know.
 *
 * @typedef {object} Seen
 * @property {string} [error] why it could not be read
 * @property {string[]} [remarks] every warning and error
 * @property {Point[]} [positions] in the file's unit, morph targets applied at their weights
 * @property {Point[]} [triangles] indices of positions, counter-clockwise from outside
 * @property {[number, number][]} [uvs]
 * @property {{ width: number, height: number }} [texture] decoded, px
 * @property {Point[]} [skin] colour of each vertex, sRGB from 0 to 255
 * @property {Point[][]} [corner_skin] or of each corner of each triangle
 * @property {[name: string | null, weight: number][]} [morphs]
 * @property {number} [unit_m] the file's unit, as the file states it
 * @property {string} [up] the file's upward axis
 * @property {boolean} [closed] whether the reader itself considers it a closed, outward body
 * @property {number} [volume] of that body, in the file's unit
 * @property {boolean} [unlit]
 * @property {Point} [size] in metres
 * @property {number} [colours] number of colours in the reader's picture of it
 */

/** The shape a file is made from, in metres. @typedef {{ places: Places, triangles: Set<string>, colours: Point[], size: Point }} Truth */

/**
 * Largest mean colour error over all vertices, of 255. Vertex colours are bytes in every format. A texture is a JPEG of the same
 * photo, read at the nearest pixel and not between four.
 */
const MOST_OFF = { colours: 0.6, photo: 5, whole: 14 };
/** Relative: the rest of eight digits and sums in 32 bits. */
const SAME_VOLUME = 1e-4;
const SAME_SIZE_M = 1e-6;
/** The command line's note about folds that leave no room for a wall. */
const ROUNDED = /rounded off by up to ([\d.]+) mm/;
/** Share of the face's triangles that may be rounded off: those at lips, lids and nostrils. */
const MOST_ROUNDED = 0.15;
/** Half the last digit of the command line's mm and cm³, and a little. */
const HALF_DIGIT = 0.051;
/** The canonical face's triangles that fill eyes and mouth. */
const FILLINGS = 898 - 852;
const BODY_CM3 = /a body of ([\d.]+) cm³/;
/** A picture of a face has many colours, of 4096; an empty one has one. */
const LEAST_COLOURS = 40;

/** The truth from a shape's JSON, in mm. @param {{ positions: Point[], triangles: Point[], colors: Point[] }} json @returns {Truth} */
export function truthOf({ positions, triangles, colors }) {
  const points = positions.map((point) => point.map((value) => value / 1000));
  const places = new Places(points);
  if (points.some((point, at) => places.at(point) !== at)) throw new Error("two vertices of the mesh share a place");
  const size = [0, 1, 2].map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  });
  return { places, triangles: new Set(triangles.map(oriented)), colours: colors, size };
}

/** Asserts that a reader has seen the truth. @param {Row} row @param {Truth} truth @param {Seen} seen @param {string} said with the file */
export function judge(row, truth, seen, said) {
  const meant = Object.entries(row.morphs ?? {});
  const { error, remarks = [], morphs = meant, up = "Y", unlit = false } = seen;
  const listed = (all) => all.map(([name, weight]) => `${name} at ${weight.toFixed(4)}`).sort();
  assert.deepEqual(
    { error, remarks, morphs: listed(morphs), up, unlit },
    { error: undefined, remarks: [], morphs: listed(meant), up: "Y", unlit: false },
  );

  const metres = METRES[row.ending] ?? 1;
  const { unit_m = metres, size = truth.size, uvs = [], colours = LEAST_COLOURS } = seen;
  assert.ok(near(unit_m / metres, 1, 1e-9), `unit ${unit_m} m, not ${metres}`);
  assert.ok(size.every((length, axis) => near(length, truth.size[axis], SAME_SIZE_M)), `size ${size} m, not ${truth.size}`);
  assert.ok(uvs.flat().every((value) => value >= 0 && value <= 1), "texture coordinates outside 0 to 1");
  assert.ok(colours >= LEAST_COLOURS, `a picture of ${colours} colours`);
  if (seen.positions) judgeMesh(row, truth, seen, said);
}

function judgeMesh(row, truth, seen, said) {
  const points = pointsOf(row, truth, seen);
  const known = points.map((point) => truth.places.at(point));
  const faces = new Set(seen.triangles.map((corners) => oriented(corners.map((corner) => known[corner]))));
  const lost = [...truth.triangles].filter((triangle) => !faces.has(triangle)).length;
  assert.ok(lost <= mayBeLost(row, truth, said), `${lost} of the face's ${truth.triangles.size} triangles missing or flipped`);
  if (row.body) {
    judgeBody(row, points, seen, said);
    judgeRounding(known, points, truth, said);
  } else if (!row.eyesAndMouth) {
    assert.equal(seen.triangles.length, truth.triangles.size, "triangles");
    assert.equal(known.filter((place) => place < 0).length, 0, "vertices where the face has none");
  }
  for (const axis of MOVED[row.ending] ?? []) {
    const lowest = seen.positions.reduce((least, point) => (point[axis] < least[axis] ? point : least));
    const lowest_m = lowest[axis] * (METRES[row.ending] ?? 1);
    assert.ok(near(lowest_m, 0, SAME_SIZE_M), `begins at ${lowest_m} m, not 0, along ${"XYZ"[axis]}`);
  }
  if (row.skin !== "none") judgeColours(row, truth, seen, known);
}

/** Metres in the model's frame. A format that moves the model is moved back by the tip of the nose, the frontmost place. */
function pointsOf({ ending }, truth, { positions }) {
  const scale = METRES[ending] ?? 1;
  const points = positions.map((point) => point.map((value) => value * scale));
  if (!(ending in MOVED)) return points;
  const [tip, meant] = [points, truth.places.list].map((all) => all.reduce((most, point) => (point[2] > most[2] ? point : most)));
  return points.map((point) => point.map((value, axis) => value - tip[axis] + meant[axis]));
}

/** How many of the face's triangles may lie elsewhere: separate pieces for eyes and mouth, and folds that were rounded off. */
function mayBeLost({ shape, body, eyesAndMouth }, truth, said) {
  if (eyesAndMouth) return FILLINGS * 4 ** shape.density;
  return body && ROUNDED.test(said) ? MOST_ROUNDED * truth.triangles.size : 0;
}

/** Closed, outward, in one piece and without handles, to us and to the reader, and of the volume the command line reports. */
function judgeBody({ ending }, points, { triangles, closed = true, volume: theirs, unit_m = METRES[ending] ?? 1 }, said) {
  const places = points.map(String);
  const characteristic = new Set(places).size - triangles.length / 2;
  const enclosed_m3 = volume(points, triangles);
  const said_cm3 = Number(BODY_CM3.exec(said)?.[1]);
  assert.equal(openEdges(triangles.map((corners) => corners.map((corner) => places[corner]))), 0, "edges open or flipped");
  assert.equal(characteristic, 2, "vertices − edges + triangles");
  assert.ok(enclosed_m3 > 0, "inside out");
  assert.ok(closed, "not closed to the reader");
  const theirs_m3 = theirs === undefined ? enclosed_m3 : theirs * unit_m ** 3;
  assert.ok(near(theirs_m3 / enclosed_m3, 1, SAME_VOLUME), `${theirs_m3} m³ to the reader, not ${enclosed_m3}`);
  assert.ok(near(said_cm3, 1e6 * enclosed_m3, HALF_DIGIT), `${said_cm3} cm³ to the command line, not ${1e6 * enclosed_m3}`);
}

/** Each place of the face has a point of the body within the distance the command line reports. */
function judgeRounding(known, points, truth, said) {
  const most_m = (Number(ROUNDED.exec(said)?.[1] ?? 0) + HALF_DIGIT) / 1000;
  const kept = new Set(known);
  const lost = truth.places.list.filter((_, place) => !kept.has(place));
  const far = lost.filter(([x, y, z]) => points.every((point) => Math.hypot(point[0] - x, point[1] - y, point[2] - z) > most_m));
  assert.equal(far.length, 0, "places of the face further off than the command line reports");
}

/** Mean colour error over the corners of the face's triangles; a body's sides and back do not count. */
function judgeColours({ skin: kind }, truth, { triangles, skin, corner_skin }, known) {
  const offs = triangles.flatMap((corners, at) => {
    if (!truth.triangles.has(oriented(corners.map((corner) => known[corner])))) return [];
    return corners.flatMap((corner, step) => {
      const shown = corner_skin?.[at][step] ?? skin?.[corner];
      return truth.colours[known[corner]].map((value, channel) => Math.abs(value - (shown?.[channel] ?? Number.NaN)));
    });
  });
  const off = offs.reduce((sum, each) => sum + each, 0) / offs.length;
  assert.ok(off < MOST_OFF[kind], `colours ${off} off in the mean, of 255; at most ${MOST_OFF[kind]}`);
}

/** Also false for NaN. */
function near(a, b, distance) {
  return Math.abs(a - b) < distance;
}
