// The files to open: every kind that the command line writes. A new option or format is a line here; the expectations follow from it.

/**
 * A file to open.
 *
 * @typedef {object} Row
 * @property {string} ending the format
 * @property {string[]} options of `rosto mesh`, without those of the shape
 * @property {Shape} shape
 * @property {"photo" | "whole" | "colours" | "none"} skin a texture of the photo or of the whole face, vertex colours,
 *   or nothing
 * @property {"solid"} [body] closed, with the face at its front
 * @property {Record<string, number>} [morphs] weights of the morph targets by name
 * @property {"pieces"} [eyesAndMouth] separate pieces, which lie elsewhere than the face's own fillings
 * @property {true} [unlit]
 */

/** @typedef {{ topology: "tessellation" | "canonical", density: number, edits: keyof typeof MAKE }} Shape */

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

/** The command line's options for edits. */
const MAKE = {
  none: [],
  made: Object.values(EDITS).flat(),
  expressed: Object.entries(SHOWN).flatMap(([name, weight]) => ["--expression", `${name}:${weight}`]),
};

/** Units in metres of the formats that have another. */
export const METRES = { stl: 0.001, "3mf": 0.001 };

/** Axes along which a format moves the model to begin at 0: a face onto the ground, a body to a printer's origin. */
export const MOVED = { "3mf": [0, 1, 2], usdz: [1] };

/** @type {{ options: string[], skin: Row["skin"] }[]} */
const BASE_COLOURS = ["whole", "photo", "colours"].map((skin) => ({ options: ["--base-colour", skin], skin }));
const MATERIALS = ["lit", "unlit"];
const MORPH_TARGETS = { options: ["--morph-targets"], morphs: Object.fromEntries(Object.keys(EDITS).map((name) => [name, 1])) };
/** @type {Pick<Row, "options" | "morphs">} */
const EXPRESSIONS = { options: ["--expressions"], morphs: { ...Object.fromEntries(BLEND_SHAPES.map((name) => [name, 0])), ...SHOWN } };

/** @type {({ edits: Shape["edits"] } & Pick<Row, "options" | "morphs">)[]} */
const EDITS_AS = [{ edits: "none", options: [] }, { edits: "made", options: [] }, { edits: "made", ...MORPH_TARGETS }, { edits: "expressed", ...EXPRESSIONS }];

/** @type {Shape} */
const FACE = { topology: "canonical", density: 2, edits: "made" };
/** With holes for eyes and mouth, and the fewest triangles. @type {Shape} */
const SHEET = { topology: "tessellation", density: 0, edits: "none" };

const [, PHOTO] = BASE_COLOURS;
const MORPHS = { shape: FACE, ...PHOTO, ...MORPH_TARGETS, options: [...PHOTO.options, ...MORPH_TARGETS.options] };
/** For animation. */
const AVATAR = { ...MORPHS, shape: { ...FACE, edits: "expressed" }, ...EXPRESSIONS, options: [...PHOTO.options, ...EXPRESSIONS.options], eyesAndMouth: "pieces" };
/** For printers. */
const BODIES = ["thickness:2", "flat:3"].map((solid) => ({ shape: FACE, options: ["--solid", solid], body: "solid" }));

/** Opened by the readers. @type {Row[]} */
export const ROWS = [
  ...["glb", "gltf", "obj", "usdz"].flatMap((ending) => BASE_COLOURS.map((base) => ({ ending, shape: FACE, ...base }))),
  ...["glb", "gltf"].flatMap((ending) => [{ ending, ...MORPHS }, { ending, ...AVATAR }]),
  ...["glb", "gltf", "obj", "usdz"].map((ending) => ({ ending, shape: SHEET, ...PHOTO })),
  ...[FACE, SHEET].map((shape) => ({ ending: "ply", shape, options: [], skin: "colours" })),
  ...[FACE, SHEET].map((shape) => ({ ending: "stl", shape, options: ["--solid", "surface"], skin: "none" })),
  ...BODIES.map((body) => ({ ending: "stl", ...body, skin: "none" })),
  ...BODIES.map((body) => ({ ending: "3mf", ...body, skin: "colours" })),
];

/** The face found by one look, and a small texture: the choices below do not depend on them. */
const quickly = (/** @type {Row["skin"]} */ skin) => ["--mediapipe", ...(skin === "whole" ? ["--texture-size", "1024"] : [])];

/** Every combination of a GLB's choices, for the validator. @type {Row[]} */
export const MATRIX = BASE_COLOURS.flatMap((base) =>
  MATERIALS.flatMap((material) =>
    EDITS_AS.flatMap(({ edits, options }) =>
      ["tessellation", "canonical"].flatMap((topology) =>
        [0, 1, 2, 3].map((density) => ({
          ending: "glb",
          shape: { topology, density, edits },
          skin: base.skin,
          options: [...quickly(base.skin), ...base.options, "--material", material, ...options],
        })),
      ),
    ),
  ),
);

/**
 * Drawn over the photo by three.js, with the largest mean colour error, of 255: a texture is the photo's own JPEG, drawn between
 * its pixels; vertex colours are interpolated between vertices.
 *
 * @type {{ row: Row, most: number }[]}
 */
export const ON_THE_PHOTO = [0, 2].flatMap((density) =>
  BASE_COLOURS.map(({ options, skin }) => ({
    row: { ending: "glb", shape: { topology: "canonical", density, edits: "none" }, options: [...options, "--material", "unlit"], skin, unlit: true },
    most: { whole: 8, photo: 3, colours: density === 0 ? 12 : 6 }[skin],
  })),
);

/** The command line's options for a row. @param {Row} row */
export function commandOf({ shape: { topology, density, edits }, options }) {
  return ["--units", "mm", "--topology", topology, "--density", String(density), ...MAKE[edits], ...options];
}
