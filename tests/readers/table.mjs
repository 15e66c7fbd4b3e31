// What is opened, by whom: every file that the command line writes, in one table; every program that is not ours, in another.
// A new option or format is a line here; what must be seen of it follows from what the line says.
import { BLEND_SHAPES } from "./arkit.mjs";

/**
 * A file to be opened.
 *
 * @typedef {object} Row
 * @property {string} ending the format
 * @property {string[]} options of `rosto mesh`, besides those that make the shape
 * @property {Shape} shape
 * @property {"photo" | "whole" | "colours" | "none"} skin what it shows at its vertices: a texture of the photo or of the whole face,
 *   their colours, or nothing
 * @property {"solid"} [body] a closed one, with the face at its front
 * @property {Record<string, number>} [morphs] its morph targets' weights by their names
 * @property {"pieces"} [eyesAndMouth] pieces of their own, which lie elsewhere: the rest is the face's
 * @property {true} [unlit]
 */

/** @typedef {{ topology: "tessellation" | "canonical", density: number, edits: keyof typeof MAKE }} Shape */

/** Edits that every kind of file is tried with: each is a morph target of its own name where edits are morph targets. */
export const EDITS = { "jaw-width": ["--slider", "jaw-width:-4"], nose: ["--region", "nose:0,0,5"] };

/** What a face shows where it shows something, of all that it could; lids that met would lie in one place. */
const SHOWN = { jawOpen: 0.6, mouthSmileLeft: 0.5, eyeBlinkRight: 0.5 };

/** How the command line is asked for edits. */
const MAKE = {
  none: [],
  made: Object.values(EDITS).flat(),
  expressed: Object.entries(SHOWN).flatMap(([name, weight]) => ["--expression", `${name}:${weight}`]),
};

/** A format's own unit in metres, where it is none. */
export const METRES = { stl: 0.001, "3mf": 0.001 };

/** The axes along which a format moves the whole, so that it begins at 0: a face on the ground, a body where printers count from. */
export const MOVED = { "3mf": [0, 1, 2], usdz: [1] };

/** @type {{ options: string[], skin: Row["skin"] }[]} */
export const BASE_COLOURS = [
  { options: ["--base-colour", "whole"], skin: "whole" },
  { options: ["--base-colour", "photo"], skin: "photo" },
  { options: ["--base-colour", "colours"], skin: "colours" },
];

/** @type {{ options: string[], unlit?: true }[]} */
export const MATERIALS = [{ options: ["--material", "lit"] }, { options: ["--material", "unlit"], unlit: true }];

/** Each edit at weight 1. */
const AT_ONE = Object.fromEntries(Object.keys(EDITS).map((name) => [name, 1]));
/** Every expression that there is. @type {Record<string, number>} */
const EXPRESSIONS = { ...Object.fromEntries(BLEND_SHAPES.map((name) => [name, 0])), ...SHOWN };

/** @type {{ edits: Shape["edits"], options: string[], morphs?: Row["morphs"] }[]} */
export const EDITS_AS = [
  { edits: "none", options: [] },
  { edits: "made", options: [] },
  { edits: "made", options: ["--morph-targets"], morphs: AT_ONE },
  { edits: "expressed", options: ["--expressions"], morphs: EXPRESSIONS },
];

export const DENSITIES = [0, 1, 2, 3];
/** @type {Shape["topology"][]} */
export const TOPOLOGIES = ["tessellation", "canonical"];

/** The shape that files of every format are written of. @type {Shape} */
const FACE = { topology: "canonical", density: 2, edits: "made" };
/** With holes for eyes and mouth, as few triangles as there are. @type {Shape} */
const SHEET = { topology: "tessellation", density: 0, edits: "none" };

const MORPHS = { options: ["--base-colour", "photo", "--morph-targets"], skin: "photo", morphs: AT_ONE };
/** As avatars are driven. */
const AVATAR = {
  shape: { topology: "canonical", density: 2, edits: "expressed" },
  options: ["--base-colour", "photo", "--expressions"],
  skin: "photo",
  morphs: EXPRESSIONS,
  eyesAndMouth: "pieces",
};

/** What printers are given. @type {Pick<Row, "shape" | "options" | "body">[]} */
const BODIES = [
  { shape: FACE, options: ["--solid", "thickness:2"], body: "solid" },
  { shape: FACE, options: ["--solid", "flat:3"], body: "solid" },
];

/** What the readers open. @type {Row[]} */
export const ROWS = [
  ...["glb", "gltf", "obj", "usdz"].flatMap((ending) => BASE_COLOURS.map((base) => ({ ending, shape: FACE, ...base }))),
  ...["glb", "gltf"].flatMap((ending) => [{ ending, shape: FACE, ...MORPHS }, { ending, ...AVATAR }]),
  ...["glb", "gltf", "obj", "usdz"].map((ending) => ({ ending, shape: SHEET, ...BASE_COLOURS[1] })),
  ...[FACE, SHEET].map((shape) => ({ ending: "ply", shape, options: [], skin: "colours" })),
  ...[FACE, SHEET].map((shape) => ({ ending: "stl", shape, options: ["--solid", "surface"], skin: "none" })),
  ...BODIES.map((body) => ({ ending: "stl", ...body, skin: "none" })),
  ...BODIES.map((body) => ({ ending: "3mf", ...body, skin: "colours" })),
];

/** The face found by one look, and a picture no larger than need be: none of the choices below depends on them. */
const quickly = (/** @type {Row["skin"]} */ skin) => ["--mediapipe", ...(skin === "whole" ? ["--texture-size", "1024"] : [])];

/** Every combination of what can be chosen about a GLB. @type {Row[]} */
export const MATRIX = BASE_COLOURS.flatMap((base) =>
  MATERIALS.flatMap((material) =>
    EDITS_AS.flatMap(({ edits, options, morphs }) =>
      TOPOLOGIES.flatMap((topology) =>
        DENSITIES.map((density) => ({
          ending: "glb",
          shape: { topology, density, edits },
          ...base,
          ...material,
          options: [...quickly(base.skin), ...base.options, ...material.options, ...options],
          ...(morphs && { morphs }),
        })),
      ),
    ),
  ),
);

/**
 * What three.js draws over the photo, and how far its colours may be off in the mean, of 255: a texture is the photo's own JPEG,
 * drawn between its pixels; a colour for each vertex knows nothing of what lies between them.
 *
 * @type {{ row: Row, most: number }[]}
 */
export const ON_THE_PHOTO = [0, 2].flatMap((density) =>
  BASE_COLOURS.map(({ options, skin }) => ({
    row: {
      ending: "glb",
      shape: { topology: "canonical", density, edits: "none" },
      options: [...options, "--material", "unlit"],
      skin,
      unlit: true,
    },
    most: { whole: 8, photo: 3, colours: density === 0 ? 12 : 6 }[skin],
  })),
);

/** All that makes the file of a row, as the command line wants it. @param {Row} row */
export function commandOf({ shape, options }) {
  const { topology, density, edits } = shape;
  return ["--units", "mm", "--topology", topology, "--density", String(density), ...MAKE[edits], ...options];
}
