// Kinds of files that the command line writes. Add a line for a new option or format; the expectations follow from it.

/**
 * A file to open.
 *
 * @typedef {object} Row
 * @property {string} ending the format
 * @property {Shape} shape
 * @property {"photo" | "whole" | "colours" | "none"} baseColour the photo or the whole-face texture, vertex colours, or nothing
 * @property {"solid"} [body] closed body with the face at its front
 * @property {Record<string, number>} [morphs] weights of the morph targets by name
 * @property {"pieces"} [eyesAndMouth] separate meshes in place of the face's fillings
 * @property {string[]} [options] further options of `rosto mesh`
 */

/** @typedef {{ topology: "tessellation" | "canonical", density: number, edits: string[] }} Shape edits: the command line's options */

/** Edits by the name of their morph target. */
const EDITS = { "jaw-width": ["--slider", "jaw-width:-4"], nose: ["--region", "nose:0,0,5"] };

/** ARKit blend shapes (ARFaceAnchor.BlendShapeLocation) except tongue and gaze. */
const BLEND_SHAPES = [
  ...[
    "browDown", "browOuterUp", "cheekSquint", "eyeBlink", "eyeSquint", "eyeWide", "jaw", "mouth", "mouthDimple", "mouthFrown",
    "mouthLowerDown", "mouthPress", "mouthSmile", "mouthStretch", "mouthUpperUp", "noseSneer",
  ].flatMap((name) => [`${name}Left`, `${name}Right`]),
  "browInnerUp", "cheekPuff", "jawForward", "jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthRollLower", "mouthRollUpper",
  "mouthShrugLower", "mouthShrugUpper",
];
/** Weighted expressions; below 1, because the points of closed lids would coincide. */
const SHOWN = { jawOpen: 0.6, mouthSmileLeft: 0.5, eyeBlinkRight: 0.5 };

const EDITED = Object.values(EDITS).flat();
const EXPRESSED = Object.entries(SHOWN).flatMap(([name, weight]) => ["--expression", `${name}:${weight}`]);

/** Units of the formats that do not use metres, in metres. */
export const METRES = { stl: 0.001, "3mf": 0.001 };

/** Axes along which a format moves the model so that it starts at 0: to the ground in AR, to a printer's origin. */
export const MOVED = { "3mf": [0, 1, 2], usdz: [1] };

/** Formats with the option `--base-colour`. */
const PAINTED = ["glb", "gltf", "obj", "usdz"];
const BASE_COLOURS = /** @type {const} */ (["whole", "photo", "colours"]);
const MORPH_TARGETS = { options: ["--morph-targets"], morphs: Object.fromEntries(Object.keys(EDITS).map((name) => [name, 1])) };
/** @type {Pick<Row, "options" | "morphs">} */
const EXPRESSIONS = { options: ["--expressions"], morphs: { ...Object.fromEntries(BLEND_SHAPES.map((name) => [name, 0])), ...SHOWN } };

/** @type {Shape} */
const FACE = { topology: "canonical", density: 2, edits: EDITED };
/** With open eyes and mouth, at the lowest density. @type {Shape} */
const OPEN_FACE = { topology: "tessellation", density: 0, edits: [] };

const MORPHS = { shape: FACE, baseColour: "photo", ...MORPH_TARGETS };
/** For animation. */
const AVATAR = { shape: { ...FACE, edits: EXPRESSED }, baseColour: "photo", ...EXPRESSIONS, eyesAndMouth: "pieces" };
/** For printers. The relief is as deep as the face. */
const BODIES = ["thickness:2", "flat:150"].map((solid) => ({ shape: FACE, options: ["--solid", solid], body: "solid" }));

/** Files for the readers. @type {Row[]} */
export const ROWS = [
  ...combinations(PAINTED, BASE_COLOURS).map(([ending, baseColour]) => ({ ending, shape: FACE, baseColour })),
  ...combinations(["glb", "gltf"], [MORPHS, AVATAR]).map(([ending, row]) => ({ ending, ...row })),
  ...PAINTED.map((ending) => ({ ending, shape: OPEN_FACE, baseColour: "photo" })),
  ...[FACE, OPEN_FACE].map((shape) => ({ ending: "ply", shape, baseColour: "colours" })),
  ...[FACE, OPEN_FACE].map((shape) => ({ ending: "stl", shape, baseColour: "none", options: ["--solid", "surface"] })),
  ...BODIES.map((body) => ({ ending: "stl", ...body, baseColour: "none" })),
  ...BODIES.map((body) => ({ ending: "3mf", ...body, baseColour: "colours" })),
];

/** All combinations of GLB options, for the validator. @type {Row[]} */
export const MATRIX = combinations(
  BASE_COLOURS,
  ["lit", "unlit"],
  [{ edits: [] }, { edits: EDITED }, { edits: EDITED, ...MORPH_TARGETS }, { edits: EXPRESSED, ...EXPRESSIONS }],
  ["tessellation", "canonical"],
  [0, 1, 2, 3],
).map(([baseColour, material, { edits, options = [] }, topology, density]) => ({
  ending: "glb",
  shape: { topology, density, edits },
  baseColour,
  // Fast detection and a small texture, which do not affect the result.
  options: ["--mediapipe", ...(baseColour === "whole" ? ["--texture-size", "1024"] : []), "--material", material, ...options],
}));

/**
 * Files that three.js draws over the photo, with the largest mean colour error, of 255. A texture is a resampled JPEG of the
 * photo; vertex colours are interpolated.
 *
 * @type {(Row & { most: number })[]}
 */
export const ON_THE_PHOTO = combinations([0, 2], BASE_COLOURS).map(([density, baseColour]) => ({
  ending: "glb",
  shape: { topology: "canonical", density, edits: [] },
  baseColour,
  options: ["--material", "unlit"],
  most: { whole: 8, photo: 3, colours: density === 0 ? 12 : 6 }[baseColour],
}));

/** The command line's options for a row. @param {Partial<Row> & Pick<Row, "shape">} row */
export function commandOf({ ending, shape: { topology, density, edits }, baseColour, options = [] }) {
  const colourOption = PAINTED.includes(ending) ? ["--base-colour", baseColour] : [];
  return ["--units", "mm", "--topology", topology, "--density", String(density), ...edits, ...colourOption, ...options];
}

/** Cartesian product of lists. */
function combinations(...lists) {
  return lists.reduce((chosen, list) => chosen.flatMap((before) => list.map((each) => [...before, each])), [[]]);
}
