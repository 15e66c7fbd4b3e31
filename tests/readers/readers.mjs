// Programs that open the files, with the formats that they read.
import { modelViewer, three } from "./chromium.mjs";
import { prusaSlicer, python } from "./programs.mjs";

/** @typedef {import("./verifier.mjs").Report} Report */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A program that opens files.
 *
 * @typedef {object} Reader
 * @property {string} name
 * @property {string[]} opens formats
 * @property {string[]} [blind] formats in which it ignores vertex colours
 * @property {(row: Row) => boolean} [supports] false for files to skip
 * @property {(t: import("node:test").TestContext, files: string[]) => Promise<(file: string) => Promise<Report>>} start resolves to a
 *   function that opens a file; throws {@link import("./programs.mjs").Missing} if the program is not installed
 */

/** Only if it could be installed, which needs Python 3.11. */
const BLENDER = process.env.ROSTO_READERS_BLENDER;

/** @type {Reader[]} */
export const READERS = [
  { name: "three.js", opens: ["glb", "gltf", "obj", "ply", "stl", "3mf", "usdz"], blind: ["usdz"], start: three },
  { name: "model-viewer", opens: ["glb"], start: modelViewer },
  {
    name: "trimesh",
    opens: ["glb", "gltf", "obj", "ply", "stl", "3mf"],
    blind: ["glb", "gltf", "3mf"],
    supports: (row) => row.morphs === undefined,
    start: python("trimesh"),
  },
  { name: "OpenUSD", opens: ["usdz"], start: python("usd") },
  { name: "lib3mf", opens: ["3mf", "stl"], start: python("lib3mf") },
  ...(BLENDER ? [{ name: "Blender", opens: ["glb", "gltf", "obj", "ply", "stl", "usdz"], start: python("blender", BLENDER) }] : []),
  { name: "PrusaSlicer", opens: ["stl", "3mf"], supports: (row) => row.body !== undefined, start: prusaSlicer },
];
