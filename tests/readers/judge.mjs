// Whether what a reader saw is what the file was made to hold: the very places, the very triangles, the very colours.
import { Places, openEdges, oriented, size, turned, volume } from "./shape.mjs";
import { METRES, MOVED } from "./table.mjs";

/** @typedef {import("./shape.mjs").Point} Point */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * What a reader says of a file; what it does not know of is left out.
 *
 * @typedef {object} Seen
 * @property {string} reader
 * @property {string} version
 * @property {string} path
 * @property {string} [error] why it could not be read
 * @property {string[]} [remarks] every warning and error
 * @property {Point[]} [positions] in the file's unit, morph targets at their weights
 * @property {Point[]} [triangles] indices of positions, counter-clockwise from outside
 * @property {[number, number][]} [uvs]
 * @property {{ width: number, height: number }} [texture] decoded, px
 * @property {Point[]} [skin] the colour shown at each vertex, sRGB from 0 to 255
 * @property {Point[][]} [corner_skin] or at each corner of each triangle
 * @property {{ name: string | null, weight: number }[]} [morphs]
 * @property {number} [unit_m] the file's unit, as the file states it
 * @property {string} [up] the file's axis that points up
 * @property {boolean} [closed] whether the reader itself takes it for a closed, outward body
 * @property {number} [volume] of that body, in the file's unit
 * @property {boolean} [unlit]
 * @property {Point} [size] of the whole, in metres
 * @property {number} [colours] how many there are in the reader's picture of it
 */

/** The shape a file is made of, in metres. @typedef {{ places: Places, triangles: Set<string>, colours: Point[], size: Point }} Truth */

/**
 * How far colours may be off, as a mean over all vertices: of 255. The vertices' own are bytes in every format. A texture is a
 * JPEG of the same photo, read at the nearest pixel and not between four.
 */
const MOST_OFF = { colours: 0.6, photo: 5, whole: 14 };
/** A share: what eight digits and sums in 32 bits leave. */
const SAME_VOLUME = 1e-4;
const SAME_SIZE_M = 1e-6;
/** What the command line says where a body's front is not the face as it is: folds may leave no room for a wall. */
const ROUNDED = /rounded off by up to ([\d.]+) mm/;
/** A share of the face's triangles: those at lips, lids and nostrils. */
const MOST_ROUNDED = 0.15;
/** Half the last digit that is told, and a little. */
const TOLD_TO_MM = 0.051;
/** So many triangles of the canonical face fill eyes and mouth. */
const FILLINGS = 898 - 852;
/** What the command line says of a body. */
const TOLD = /a body of ([\d.]+) cm³/;
/** Half its last digit, and a little. */
const TOLD_TO_CM3 = 0.051;
/** A picture of a face has many colours, of 4096; one of nothing has one. */
const LEAST_COLOURS = 40;

/** What a shape is, from its JSON. @param {{ positions: Point[], triangles: Point[], colors: Point[] }} json mm @returns {Truth} */
export function truthOf({ positions, triangles, colors }) {
  const points = positions.map((point) => point.map((value) => value / 1000));
  const places = new Places(points);
  if (places.list.length !== points.length) throw new Error("two vertices of the mesh lie in one place");
  return { places, triangles: oriented(triangles), colours: colors, size: size(points) };
}

/** Everything that is not as it should be; nothing of a file that holds what it was made to hold. @param {Row} row @param {Truth} truth @param {Seen} seen @param {string} [said] by the command line about the file */
export function findings(row, truth, seen, said = "") {
  if (seen.error) return [seen.error, ...(seen.remarks ?? [])];
  return [...(seen.remarks ?? []), ...shapeFindings(row, truth, seen, said), ...skinFindings(row, truth, seen), ...morphFindings(row, seen), ...statedFindings(row, seen)];
}

/** What a reader saw, as places and triangles in metres in the model's frame. @param {Row} row @param {Truth} truth @param {Seen} seen */
export function meshOf(row, truth, seen) {
  const points = pointsOf(row, truth, seen);
  const places = new Places();
  const placeOf = points.map((point) => places.put(point));
  return { points, places, triangles: seen.triangles.map((corners) => corners.map((corner) => placeOf[corner])) };
}

/** In the model's frame. A format that moves the whole is moved back by the tip of the nose, the one place that is furthest out. */
function pointsOf({ ending }, truth, { positions }) {
  const scale = METRES[ending] ?? 1;
  const points = positions.map((point) => point.map((value) => value * scale));
  if (!(ending in MOVED)) return points;
  const [tip, meant] = [points, truth.places.list].map((all) => all.reduce((most, point) => (point[2] > most[2] ? point : most)));
  return points.map((point) => point.map((value, axis) => value - tip[axis] + meant[axis]));
}

/** How far the colours of the face's triangles are from the truth's, as a mean over their corners; not a number where none are seen. @param {Row} row @param {Truth} truth @param {Seen} seen */
export function colourError(row, truth, seen) {
  if (!seen.skin && !seen.corner_skin) return Number.NaN;
  const places = pointsOf(row, truth, seen).map((point) => truth.places.at(point));
  // A body's sides and back are of no colour of the face.
  const isFace = (/** @type {number[]} */ corners) => truth.triangles.has(turned(corners.map((corner) => places[corner])));
  let [sum, count] = [0, 0];
  for (const [at, corners] of seen.triangles.entries()) {
    if (!isFace(corners)) continue;
    for (const [step, corner] of corners.entries()) {
      const shown = seen.corner_skin?.[at][step] ?? seen.skin[corner];
      const meant = truth.colours[places[corner]];
      sum += meant.reduce((off, value, channel) => off + Math.abs(value - shown[channel]), 0) / meant.length;
      count += 1;
    }
  }
  return sum / count;
}

function shapeFindings(row, truth, seen, said) {
  const wrongSize = seen.size?.some((length, axis) => Math.abs(length - truth.size[axis]) > SAME_SIZE_M);
  const sized = wrongSize ? [`${seen.size.join(" × ")} m in size, not ${truth.size.join(" × ")}`] : [];
  if (!seen.positions) return sized;
  const { points, places, triangles } = meshOf(row, truth, seen);
  const known = points.map((point) => truth.places.at(point));
  const inTruth = places.list.map((point) => truth.places.at(point));
  const faces = oriented(triangles.map((corners) => corners.map((corner) => inTruth[corner])));
  const lost = [...truth.triangles].filter((triangle) => !faces.has(triangle)).length;
  const found = lost > mayBeLost(row, truth, said) ? [`${lost} of the face's ${truth.triangles.size} triangles are missing or turned over`] : [];
  const ofBody = () => [...bodyFindings(places.list, triangles, seen, said), ...roundingFindings(known, points, truth, said)];
  const more = row.body ? ofBody() : row.eyesAndMouth ? [] : sheetFindings(known, triangles, truth);
  return [...sized, ...found, ...more, ...placeFindings(row, seen)];
}

/** How many of the face's triangles may lie elsewhere: those of eyes and mouth in pieces of their own, and what was rounded off. */
function mayBeLost({ shape, body, eyesAndMouth }, truth, said) {
  if (eyesAndMouth) return FILLINGS * 4 ** shape.density;
  return body && ROUNDED.test(said) ? MOST_ROUNDED * truth.triangles.size : 0;
}

/** Whether a body has something within what is told of each place of the face. */
function roundingFindings(known, points, truth, said) {
  const most_m = (Number(ROUNDED.exec(said)?.[1] ?? 0) + TOLD_TO_MM) / 1000;
  const kept = new Set(known);
  const lost = truth.places.list.filter((_, place) => !kept.has(place));
  const isFar = (/** @type {number[]} */ place) => points.every((point) => Math.hypot(...point.map((value, axis) => value - place[axis])) > most_m);
  const far = lost.filter(isFar).length;
  return far > 0 ? [`${far} places of the face lie further off than the command line says`] : [];
}

/** Whether a format that moves the whole has it begin at 0. */
function placeFindings({ ending }, { positions }) {
  return (MOVED[ending] ?? []).flatMap((axis) => {
    const lowest_m = (METRES[ending] ?? 1) * positions.reduce((least, point) => Math.min(least, point[axis]), Number.POSITIVE_INFINITY);
    return Math.abs(lowest_m) < SAME_SIZE_M ? [] : [`along ${"XYZ"[axis]} it begins at ${lowest_m} m, not 0`];
  });
}

function sheetFindings(known, triangles, truth) {
  const strange = known.filter((place) => place < 0).length;
  const wrong = triangles.length === truth.triangles.size ? [] : [`${triangles.length} triangles, not ${truth.triangles.size}`];
  return strange > 0 ? [...wrong, `${strange} vertices lie where the face has none`] : wrong;
}

/** A body is closed, outward, in one piece and without handles, to us and to the reader, and of the volume that the command line told. */
function bodyFindings(points, triangles, seen, said) {
  const open = openEdges(triangles);
  const enclosed_m3 = volume({ positions: points, triangles });
  const characteristic = points.length - triangles.length / 2;
  return [
    ...(open > 0 ? [`${open} edges are open or turned over`] : []),
    ...(characteristic === 2 ? [] : [`vertices − edges + triangles is ${characteristic}, not 2`]),
    ...(enclosed_m3 > 0 ? [] : ["it is inside out"]),
    ...(seen.closed === false ? ["it is not closed to the reader"] : []),
    ...volumeFindings(seen, enclosed_m3),
    ...toldFindings(said, 1e6 * enclosed_m3),
  ];
}

function volumeFindings({ volume: said, unit_m, path }, enclosed_m3) {
  if (said === undefined) return [];
  const said_m3 = said * (unit_m ?? METRES[path.split(".").at(-1)] ?? 1) ** 3;
  return Math.abs(said_m3 / enclosed_m3 - 1) < SAME_VOLUME ? [] : [`${said_m3} m³ to the reader, not ${enclosed_m3}`];
}

/** @param {string} said @param {number} enclosed_cm3 */
function toldFindings(said, enclosed_cm3) {
  const told_cm3 = Number(TOLD.exec(said)?.[1]);
  return Math.abs(told_cm3 - enclosed_cm3) < TOLD_TO_CM3 ? [] : [`${told_cm3} cm³ to the command line, not ${enclosed_cm3}`];
}

function skinFindings(row, truth, seen) {
  const outside = (seen.uvs ?? []).flat().filter((value) => !(value >= 0 && value <= 1)).length;
  const found = outside > 0 ? [`${outside} texture coordinates are not from 0 to 1`] : [];
  if (seen.colours !== undefined && seen.colours < LEAST_COLOURS) found.push(`a picture of ${seen.colours} colours`);
  if (!seen.positions || row.skin === "none") return found;
  const off = colourError(row, truth, seen);
  const most = MOST_OFF[row.skin];
  return off < most ? found : [...found, `colours are ${off} off in the mean, of 255; the most is ${most}`];
}

function morphFindings({ morphs = {} }, seen) {
  if (!seen.morphs) return [];
  const told = (all) => all.map(({ name, weight }) => `${name} at ${weight.toFixed(4)}`).sort().join(", ");
  const [said, meant] = [told(seen.morphs), told(Object.entries(morphs).map(([name, weight]) => ({ name, weight })))];
  return said === meant ? [] : [`the morph targets are ${said || "none"}, not ${meant || "none"}`];
}

/** What the file says of itself. */
function statedFindings({ ending, unlit = false }, seen) {
  const unit_m = METRES[ending] ?? 1;
  return [
    ...(seen.unit_m !== undefined && Math.abs(seen.unit_m / unit_m - 1) > 1e-9 ? [`its unit is ${seen.unit_m} m, not ${unit_m}`] : []),
    ...(seen.up !== undefined && seen.up !== "Y" ? [`${seen.up} points up`] : []),
    ...(seen.unlit !== undefined && seen.unlit !== unlit ? [seen.unlit ? "it is unlit" : "it is lit"] : []),
  ];
}
