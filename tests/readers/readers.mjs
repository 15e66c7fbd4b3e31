// The programs that open the files, each with the formats it reads. None of them is ours.
import { modelViewer, three } from "./chromium.mjs";
import { prusaSlicer, python } from "./programs.mjs";

/** @typedef {import("./judge.mjs").Seen} Seen */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A program that opens files.
 *
 * @typedef {object} Reader
 * @property {string} name
 * @property {string[]} opens formats
 * @property {string[]} [blind] formats in which it shows no vertex colours
 * @property {(row: Row) => boolean} [knows] false for files it has no notion of, which it is not given
 * @property {(t: import("node:test").TestContext, files: string[]) => Promise<(file: string) => Promise<Seen>>} start resolves to what
 *   opens one of the files; throws {@link import("./programs.mjs").Missing} where the program is not installed
 */

/** Several times as large as all the others together: only where `cargo xtask readers` has installed it. */
const BLENDER = process.env.ROSTO_READERS_BLENDER;

/** @type {Reader[]} */
export const READERS = [
  { name: "three.js", opens: ["glb", "gltf", "obj", "ply", "stl", "3mf", "usdz"], blind: ["usdz"], start: three },
  { name: "model-viewer", opens: ["glb"], start: modelViewer },
  {
    name: "trimesh",
    opens: ["glb", "gltf", "obj", "ply", "stl", "3mf"],
    blind: ["glb", "gltf", "3mf"],
    knows: (row) => row.morphs === undefined,
    start: python("trimesh"),
  },
  { name: "OpenUSD", opens: ["usdz"], start: python("usd") },
  { name: "lib3mf", opens: ["3mf", "stl"], start: python("lib3mf") },
  ...(BLENDER ? [{ name: "Blender", opens: ["glb", "gltf", "obj", "ply", "stl", "usdz"], start: python("blender", BLENDER) }] : []),
  { name: "PrusaSlicer", opens: ["stl", "3mf"], knows: (row) => row.body !== undefined, start: prusaSlicer },
];
