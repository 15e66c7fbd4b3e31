// Who opens the files: a line for each program, with the formats it knows. None of them is ours.
import { showInModelViewer, readByThree } from "./chromium.mjs";
import { BLENDER, python } from "./python.mjs";
import { slice } from "./slicer.mjs";

/** @typedef {import("./judge.mjs").Seen} Seen */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A program that opens files.
 *
 * @typedef {object} Reader
 * @property {string} name
 * @property {string} what it is
 * @property {string[]} opens formats
 * @property {(row: Row) => boolean} [knows] what it has no notion of it is not given
 * @property {(row: Row) => boolean} [blind] where it shows no colours of vertices
 * @property {(files: string[]) => Promise<Seen[]>} read throws a {@link import("./missing.mjs").Missing} where the program is not there
 */

/** @param {Row} row */
const isBody = (row) => row.body !== undefined;
/** @param {Row} row */
const isAtRest = (row) => row.morphs === undefined;
/** @param {...string} endings */
const coloursIn = (...endings) => (/** @type {Row} */ row) => row.skin !== "photo" && row.skin !== "whole" && endings.includes(row.ending);

/** @type {Reader[]} */
export const READERS = [
  { name: "three.js", what: "its loader for each format", opens: ["glb", "gltf", "obj", "ply", "stl", "3mf", "usdz"], blind: coloursIn("usdz"), read: readByThree },
  { name: "model-viewer", what: "Google’s `<model-viewer>`", opens: ["glb"], read: showInModelViewer },
  { name: "trimesh", what: "Python", opens: ["glb", "gltf", "obj", "ply", "stl", "3mf"], knows: isAtRest, blind: coloursIn("glb", "gltf", "3mf"), read: python("trimesh") },
  { name: "pygltflib", what: "Python, with Pillow for the pictures", opens: ["glb", "gltf"], read: python("pygltflib") },
  { name: "OpenUSD", what: "with its own checks and those for Apple’s AR Quick Look", opens: ["usdz"], read: python("usd") },
  { name: "lib3mf", what: "the 3MF Consortium’s own, strict", opens: ["3mf", "stl"], read: python("lib3mf") },
  { name: "Blender", what: "the importer that its menu offers for each format", opens: ["glb", "gltf", "obj", "ply", "stl", "usdz"], read: python("blender", BLENDER) },
  { name: "PrusaSlicer", what: "the body sliced for a printer", opens: ["stl", "3mf", "obj"], knows: isBody, read: slice },
];
