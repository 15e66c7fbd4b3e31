// The files to open: every kind that the command line writes. A new option or format is a line here; the expectations follow from it.

/**
 * A file to open.
 *
 * @typedef {object} Row
 * @property {string} ending the format
 * @property {Shape} shape
 * @property {"photo" | "whole" | "colours" | "none"} skin a texture of the photo or of the whole face, vertex colours,
 *   or nothing
 * @property {"solid"} [body] closed, with the face at its front
 * @property {Record<string, number>} [morphs] weights of the morph targets by name
 * @property {"pieces"} [eyesAndMouth] separate pieces, which lie elsewhere than the face's own fillings
 * @property {string[]} [options] of `rosto mesh`, without those that follow from the properties above
 */

/** @typedef {{ topology: "tessellation" | "canonical", density: number, edits: string[] }} Shape edits: the command line's options */

/** Each is a morph target of its own name where edits are morph targets. */
const EDITS = { "jaw-width": ["--slider", "jaw-width:-4"], nose: ["--region", "nose:0,0,5"] };

/** ARKit's names of blend shapes (ARFaceAnchor.BlendShapeLocation), without tongue and gaze, which a face mesh has no parts for. */
const BLEND_SHAPES = [
  ...[
    "browDown", "browOuterUp", "cheekSquint", "eyeBlink", "eyeSquint", "eyeWide", "jaw", "mouth", "mouthDimple", "mouthFrown",
    "mouthLowerDown", "mouthPress", "mouthSmile", "mouthStretch", "mouthUpperUp", "noseSneer",
  ].flatMap((name) => [`${name}Left`, `${name}Right`]),
  "browInnerUp", "cheekPuff", "jawForward", "jawOpen", "mouthClose", "mouthFunnel", "mouthPucker", "mouthRollLower", "mouthRollUpper",
  "mouthShrugLower", "mouthShrugUpper",
];
/** Expressions with a weight; closed lids would share places. */
const SHOWN = { jawOpen: 0.6, mouthSmileLeft: 0.5, eyeBlinkRight: 0.5 };

const EDITED = Object.values(EDITS).flat();
const EXPRESSED = Object.entries(SHOWN).flatMap(([name, weight]) => ["--expression", `${name}:${weight}`]);

/** Units in metres of the formats that have another. */
export const METRES = { stl: 0.001, "3mf": 0.001 };

/** Axes along which a format moves the model to begin at 0: a face onto the ground, a body to a printer's origin. */
export const MOVED = { "3mf": [0, 1, 2], usdz: [1] };

/** Formats with a choice of base colour. */
const PAINTED = ["glb", "gltf", "obj", "usdz"];
const SKINS = /** @type {const} */ (["whole", "photo", "colours"]);
const MORPH_TARGETS = { options: ["--morph-targets"], morphs: Object.fromEntries(Object.keys(EDITS).map((name) => [name, 1])) };
/** @type {Pick<Row, "options" | "morphs">} */
const EXPRESSIONS = { options: ["--expressions"], morphs: { ...Object.fromEntries(BLEND_SHAPES.map((name) => [name, 0])), ...SHOWN } };

/** @type {Shape} */
const FACE = { topology: "canonical", density: 2, edits: EDITED };
/** With holes for eyes and mouth, and the fewest triangles. @type {Shape} */
const SHEET = { topology: "tessellation", density: 0, edits: [] };

const MORPHS = { shape: FACE, skin: "photo", ...MORPH_TARGETS };
/** For animation. */
const AVATAR = { shape: { ...FACE, edits: EXPRESSED }, skin: "photo", ...EXPRESSIONS, eyesAndMouth: "pieces" };
/** For printers. */
const BODIES = ["thickness:2", "flat:3"].map((solid) => ({ shape: FACE, options: ["--solid", solid], body: "solid" }));

/** Opened by the readers. @type {Row[]} */
export const ROWS = [
  ...combinations(PAINTED, SKINS).map(([ending, skin]) => ({ ending, shape: FACE, skin })),
  ...combinations(["glb", "gltf"], [MORPHS, AVATAR]).map(([ending, row]) => ({ ending, ...row })),
  ...PAINTED.map((ending) => ({ ending, shape: SHEET, skin: "photo" })),
  ...[FACE, SHEET].map((shape) => ({ ending: "ply", shape, skin: "colours" })),
  ...[FACE, SHEET].map((shape) => ({ ending: "stl", shape, skin: "none", options: ["--solid", "surface"] })),
  ...BODIES.map((body) => ({ ending: "stl", ...body, skin: "none" })),
  ...BODIES.map((body) => ({ ending: "3mf", ...body, skin: "colours" })),
];

/** Every combination of a GLB's choices, for the validator. @type {Row[]} */
export const MATRIX = combinations(
  SKINS,
  ["lit", "unlit"],
  [{ edits: [] }, { edits: EDITED }, { edits: EDITED, ...MORPH_TARGETS }, { edits: EXPRESSED, ...EXPRESSIONS }],
  ["tessellation", "canonical"],
  [0, 1, 2, 3],
).map(([skin, material, { edits, options = [] }, topology, density]) => ({
  ending: "glb",
  shape: { topology, density, edits },
  skin,
  // The face found by one look, and a small texture: the choices do not depend on them.
  options: ["--mediapipe", ...(skin === "whole" ? ["--texture-size", "1024"] : []), "--material", material, ...options],
}));

/**
 * Drawn over the photo by three.js, with the largest mean colour error, of 255: a texture is the photo's own JPEG, drawn between
 * its pixels; vertex colours are interpolated between vertices.
 *
 * @type {(Row & { most: number })[]}
 */
export const ON_THE_PHOTO = combinations([0, 2], SKINS).map(([density, skin]) => ({
  ending: "glb",
  shape: { topology: "canonical", density, edits: [] },
  skin,
  options: ["--material", "unlit"],
  most: { whole: 8, photo: 3, colours: density === 0 ? 12 : 6 }[skin],
}));

/** The command line's options for a row. @param {Partial<Row> & Pick<Row, "shape">} row */
export function commandOf({ ending, shape: { topology, density, edits }, skin, options = [] }) {
  const baseColour = PAINTED.includes(ending) ? ["--base-colour", skin] : [];
  return ["--units", "mm", "--topology", topology, "--density", String(density), ...edits, ...baseColour, ...options];
}

/** Every choice of one from each list. */
function combinations(...lists) {
  return lists.reduce((chosen, list) => chosen.flatMap((before) => list.map((each) => [...before, each])), [[]]);
}
