// What a run saw, as tables for the documentation.
import path from "node:path";
import { colourError, meshOf } from "./judge.mjs";
import { size, volume } from "./shape.mjs";
import { DENSITIES } from "./table.mjs";

/** @typedef {import("./files.mjs").Written} Written */
/** @typedef {import("./judge.mjs").Seen} Seen */
/** @typedef {import("./judge.mjs").Truth} Truth */
/** @typedef {{ reader: import("./readers.mjs").Reader, files: Written[], seen: Seen[], missing?: string }} Opened */
/** @typedef {Written & { counts: string }} Validated */

/**
 * @param {{ files: (Written & { truth: Truth })[], readers: Opened[], matrix: Validated[], photos: import("./on-the-photo.mjs").Laid[] }} run
 */
export function tables({ files, readers, matrix, photos }) {
  const opened = files.map((file) => ({ ...file, by: seenOf(file, readers) }));
  const bodies = opened.filter(({ row }) => row.body);
  return [
    section("The programs", programs(readers)),
    section("The files", table(FILE_COLUMNS, opened.map(fileCells))),
    ...(bodies.length > 0 ? [section("The bodies, for printers", table(BODY_COLUMNS, bodies.map(bodyCells)))] : []),
    ...(matrix.length > 0 ? [section("Every combination of a GLB’s choices", choices(matrix))] : []),
    ...(photos.length > 0 ? [section("On the photo", table(PHOTO_COLUMNS, photos.map(photoCells)))] : []),
  ].join("\n\n");
}

const FILE_COLUMNS = ["file", "opened alike by", "vertices", "triangles", "size", "texture", "colours off by", "morph targets"];
const BODY_COLUMNS = ["file", "volume", "closed to", "PrusaSlicer’s repairs", "layers", "filament", "time"];
const PHOTO_COLUMNS = ["file", "landmarks off by, at most", "pixels compared", "colours off by, in the mean", "a px beside"];

/** @param {Opened[]} readers */
function programs(readers) {
  const rows = readers.map(({ reader, seen, missing }) => {
    const remarks = seen.flatMap((one) => one.remarks ?? []).length;
    const version = seen.find((one) => one.version)?.version ?? "–";
    return [reader.name, version, reader.what, reader.opens.join(", "), missing ? `left out: ${missing}` : seen.length, missing ? "–" : remarks];
  });
  return table(["program", "version", "what reads", "formats", "files opened", "warnings and errors"], rows);
}

/** What each reader saw of a file. @param {Written} file @param {Opened[]} readers @returns {Seen[]} */
function seenOf({ path: wanted }, readers) {
  return readers.flatMap(({ seen }) => seen.filter((one) => one.path === wanted && !one.error));
}

/** All readers see the same, which the tests make sure of; what one of them sees stands for all. */
function fileCells({ path: file, row, truth, by }) {
  const shapes = by.filter((seen) => seen.positions);
  const shape = shapes[0] && meshOf(row, truth, shapes[0]);
  const off = Math.max(...shapes.map((seen) => colourError(row, truth, seen)).filter(Number.isFinite));
  const texture = by.find((seen) => seen.texture)?.texture;
  return [
    nameOf(file),
    by.map(({ reader }) => reader).join(", "),
    shape ? shape.places.list.length : "–",
    shape ? shape.triangles.length : "–",
    shape ? millimetres(size(shape.places.list)) : "–",
    texture ? `${texture.width} × ${texture.height}` : "–",
    row.skin === "none" || !Number.isFinite(off) ? "–" : off.toFixed(1),
    row.morphs ? morphsOf(Object.keys(row.morphs)) : "–",
  ];
}

/** Too many for a cell are counted. @param {string[]} names */
function morphsOf(names) {
  return names.length > 3 ? `${names.length} expressions` : names.join(", ");
}

function bodyCells({ path: file, row, truth, by }) {
  const shape = by.find((seen) => seen.positions);
  const { places, triangles } = meshOf(row, truth, shape);
  const slicer = by.find(({ sliced }) => sliced);
  const cm3 = 1e6 * volume({ positions: places.list, triangles });
  const closed = by.filter((seen) => seen.closed).map(({ reader }) => reader);
  const cut = slicer ? [slicer.remarks.length, slicer.sliced.layers, `${slicer.sliced.filament_g.toFixed(0)} g`, slicer.sliced.time] : ["–", "–", "–", "–"];
  return [nameOf(file), `${cm3.toFixed(1)} cm³`, closed.join(", "), ...cut];
}

/** A row for each choice, a column for each density: the validator's counts of errors, warnings, remarks and hints. @param {Validated[]} matrix */
function choices(matrix) {
  const kinds = [...new Set(matrix.map(kindOf))];
  const countsOf = (kind, density) => matrix.find((one) => kindOf(one) === kind && one.row.shape.density === density)?.counts ?? "–";
  const rows = kinds.map((kind) => [...kind.split("|"), ...DENSITIES.map((density) => countsOf(kind, density))]);
  return table(["base colour", "material", "edits", "triangles", ...DENSITIES.map((density) => `density ${density}`)], rows);
}

/** @param {Validated} one */
function kindOf({ row: { options, shape, morphs, unlit } }) {
  const baseColour = options[options.indexOf("--base-colour") + 1];
  const edits = morphs ? { made: "morph targets", expressed: "expressions" }[shape.edits] : { none: "none", made: "in the shape" }[shape.edits];
  return [baseColour, unlit ? "unlit" : "lit", edits, shape.topology].join("|");
}

/** @param {import("./on-the-photo.mjs").Laid} laid */
function photoCells({ name, landmarks_px, pixels, off, beside }) {
  return [`\`${name}\``, `${landmarks_px.toFixed(3)} px`, pixels, off.toFixed(1), beside.toFixed(1)];
}

function nameOf(file) {
  return `\`${path.basename(file)}\``;
}

/** @param {number[]} lengths_m */
function millimetres(lengths_m) {
  return `${lengths_m.map((length) => (1000 * length).toFixed(1)).join(" × ")} mm`;
}

/** @param {string} title @param {string} body */
function section(title, body) {
  return `### ${title}\n\n${body}`;
}

/** @param {string[]} columns @param {(string | number)[][]} rows */
function table(columns, rows) {
  const line = (/** @type {(string | number)[]} */ cells) => `| ${cells.join(" | ")} |`;
  return [line(columns), line(columns.map(() => "---")), ...rows.map(line)].join("\n");
}
