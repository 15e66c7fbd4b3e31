// The verifier accepts a correct body, and finds faults planted in it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { verify, truthOf } from "./verifier.mjs";

/** @typedef {import("./verifier.mjs").Report} Report */

/** The cut-off corner of a cube: three triangles are the face, and the fourth closes it. */
const CORNERS_MM = [[0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 10]];
const FACE = [[0, 2, 1], [0, 1, 3], [0, 3, 2]];
const BACK = [1, 2, 3];
const COLOURS = [[200, 150, 130], [60, 40, 30], [220, 180, 160], [120, 60, 50]];
const METRES = CORNERS_MM.map((point) => point.map((value) => value / 1000));
const TRUTH = truthOf({ positions: CORNERS_MM, triangles: FACE, colours: COLOURS });
/** The command line's output about the body. */
const PRINTED = "a body of 0.2 cm³";

/** @type {import("./table.mjs").Row["shape"]} */
const SHAPE = { topology: "canonical", density: 0, edits: [] };
/** @type {import("./table.mjs").Row} */
const ROW = { ending: "glb", shape: SHAPE, baseColour: "colours", body: "solid", morphs: { smile: 1 } };

/** @type {Report} */
const RIGHT = {
  positions: METRES,
  triangles: [...FACE, BACK],
  uvs: [[0, 0], [1, 0], [0, 1], [1, 1]],
  vertex_colours: COLOURS,
  morphs: [["smile", 1]],
  unit_m: 1,
  up: "Y",
  closed: true,
  volume: 1e-6 / 6,
  unlit: false,
  size: [0.01, 0.01, 0.01],
  colours: 100,
  remarks: [],
};

/** @type {Record<string, Partial<Report> & { printed?: string }>} */
const FAULTS = {
  "an unreadable file": { error: "no such file" },
  "a warning": { remarks: ["a texture is missing"] },
  "a vertex 0.1 mm away": { positions: METRES.with(3, [0, 0, 0.0101]) },
  "lengths in millimetres": { positions: CORNERS_MM },
  "a mirrored face": { positions: METRES.map(([x, y, z]) => [-x, y, z]) },
  "a flipped triangle": { triangles: [[0, 1, 2], ...FACE.slice(1), BACK] },
  "an inside-out body": { triangles: [...FACE, BACK].map(([a, b, c]) => [a, c, b]) },
  "a missing triangle": { triangles: [...FACE.slice(1), BACK] },
  "an open back": { triangles: FACE },
  "a duplicate triangle": { triangles: [...FACE, BACK, BACK] },
  "an upside-down texture": { vertex_colours: COLOURS.toReversed() },
  "no colours": { vertex_colours: undefined },
  "linear colours": { vertex_colours: COLOURS.map((colour) => colour.map((value) => 255 * (value / 255) ** 2.2)) },
  "texture coordinates outside the texture": { uvs: [[0, 0], [1.5, 0], [0, 1], [1, 1]] },
  "an unnamed morph target": { morphs: [[null, 1]] },
  "a morph target at rest": { morphs: [["smile", 0]] },
  "no morph target": { morphs: [] },
  "another unit": { unit_m: 0.001 },
  "Z up": { up: "Z" },
  "a body that the reader considers open": { closed: false },
  "another volume": { volume: 1.01e-6 / 6 },
  "another volume reported by the command line": { printed: "a body of 0.4 cm³" },
  "an unlit material": { unlit: true },
  "another size": { size: [0.01, 0.01, 0.0101] },
  "an empty rendering": { colours: 1 },
};

test("accepts a correct body", () => verify(ROW, TRUTH, RIGHT, PRINTED));

for (const [name, { printed = PRINTED, ...fault }] of Object.entries(FAULTS)) {
  test(`finds ${name}`, () => assert.throws(() => verify(ROW, TRUTH, { ...RIGHT, ...fault }, printed), assert.AssertionError));
}
