// The programs that open the files, each with the formats it reads. None of them is ours.
import { readByThree, showInModelViewer } from "./chromium.mjs";
import { python, slice } from "./programs.mjs";

/** @typedef {import("./judge.mjs").Seen} Seen */
/** @typedef {import("./table.mjs").Row} Row */

/**
 * A program that opens files.
 *
 * @typedef {object} Reader
 * @property {string} name
 * @property {string[]} opens formats
 * @property {(row: Row) => boolean} [knows] false for files it has no notion of, which it is not given
 * @property {(row: Row) => boolean} [blind] where it shows no vertex colours
 * @property {(files: string[]) => Promise<Seen[]>} read throws {@link import("./programs.mjs").Missing} where the program is not installed
 */

/** Several times as large as all the others together: only where `cargo xtask readers` has installed it. */
const BLENDER = "ROSTO_READERS_BLENDER";

/** @param {...string} endings */
const coloursIn = (...endings) => (/** @type {Row} */ row) => row.skin !== "photo" && row.skin !== "whole" && endings.includes(row.ending);

/** @type {Reader[]} */
export const READERS = [
  { name: "three.js", opens: ["glb", "gltf", "obj", "ply", "stl", "3mf", "usdz"], blind: coloursIn("usdz"), read: readByThree },
  { name: "model-viewer", opens: ["glb"], read: showInModelViewer },
  {
    name: "trimesh",
    opens: ["glb", "gltf", "obj", "ply", "stl", "3mf"],
    knows: (row) => row.morphs === undefined,
    blind: coloursIn("glb", "gltf", "3mf"),
    read: python("trimesh"),
  },
  { name: "pygltflib", opens: ["glb", "gltf"], read: python("pygltflib") },
  { name: "OpenUSD", opens: ["usdz"], read: python("usd") },
  { name: "lib3mf", opens: ["3mf", "stl"], read: python("lib3mf") },
  ...(process.env[BLENDER] ? [{ name: "Blender", opens: ["glb", "gltf", "obj", "ply", "stl", "usdz"], read: python("blender", BLENDER) }] : []),
  { name: "PrusaSlicer", opens: ["stl", "3mf", "obj"], knows: (row) => row.body !== undefined, read: slice },
];
