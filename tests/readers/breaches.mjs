// The judge would see a breach: it is shown a body that is right, and the same with one thing wrong each time.
import { findings, truthOf } from "./judge.mjs";

/** @typedef {import("./judge.mjs").Seen} Seen */

/** A corner of a cube cut off: three triangles are the face, the fourth closes it. */
const CORNERS_MM = [[0, 0, 0], [10, 0, 0], [0, 10, 0], [0, 0, 10]];
const FACE = [[0, 2, 1], [0, 1, 3], [0, 3, 2]];
const BACK = [1, 2, 3];
const COLOURS = [[200, 150, 130], [60, 40, 30], [220, 180, 160], [120, 60, 50]];

const TRUTH = truthOf({ positions: CORNERS_MM, triangles: FACE, colors: COLOURS });
const METRES = CORNERS_MM.map((point) => point.map((value) => value / 1000));

/** @type {import("./table.mjs").Row} */
const ROW = { ending: "glb", options: [], shape: { topology: "canonical", density: 0, edits: "none" }, skin: "colours", body: "solid", morphs: { smile: 1 } };

/** @type {Seen} */
const RIGHT = {
  reader: "nobody",
  version: "0",
  path: "right.glb",
  positions: METRES,
  triangles: [...FACE, BACK],
  uvs: [[0, 0], [1, 0], [0, 1], [1, 1]],
  skin: COLOURS,
  morphs: [{ name: "smile", weight: 1 }],
  unit_m: 1,
  up: "Y",
  closed: true,
  volume: 1e-6 / 6,
  unlit: false,
  size: [0.01, 0.01, 0.01],
  colours: 100,
  remarks: [],
};

/** @type {Record<string, Partial<Seen>>} */
const WRONG = {
  "it cannot be read": { error: "no such file" },
  "a warning": { remarks: ["a texture is missing"] },
  "a vertex a tenth of a millimetre away": { positions: METRES.with(3, [0, 0, 0.0101]) },
  "every length in millimetres": { positions: CORNERS_MM },
  "a mirrored face": { positions: METRES.map(([x, y, z]) => [-x, y, z]) },
  "a triangle turned over": { triangles: [[0, 1, 2], ...FACE.slice(1), BACK] },
  "every triangle turned over": { triangles: [...FACE, BACK].map(([a, b, c]) => [a, c, b]) },
  "a triangle missing": { triangles: [...FACE.slice(1), BACK] },
  "an open back": { triangles: FACE },
  "a triangle twice": { triangles: [...FACE, BACK, BACK] },
  "an upside-down texture": { skin: COLOURS.toReversed() },
  "no colours": { skin: undefined },
  "colours as light": { skin: COLOURS.map((colour) => colour.map((value) => 255 * (value / 255) ** 2.2)) },
  "texture coordinates beside the texture": { uvs: [[0, 0], [1.5, 0], [0, 1], [1, 1]] },
  "a morph target without its name": { morphs: [{ name: null, weight: 1 }] },
  "a morph target at rest": { morphs: [{ name: "smile", weight: 0 }] },
  "no morph target": { morphs: [] },
  "another unit": { unit_m: 0.001 },
  "Z up": { up: "Z" },
  "a body that is not closed to the reader": { closed: false },
  "another volume": { volume: 1.01e-6 / 6 },
  "no light on it": { unlit: true },
  "another size": { size: [0.01, 0.01, 0.0101] },
  "an empty picture": { colours: 1 },
};

/** What the command line says of it. */
const SAID = "a body of 0.2 cm³";

/** What is wrong with the judge, by breach. @returns {{ name: string, findings: string[] }[]} */
export function breaches() {
  const unseen = Object.entries(WRONG).map(([name, wrong]) => ({
    name: `a breach is seen: ${name}`,
    findings: missedBy(findings(ROW, TRUTH, { ...RIGHT, ...wrong }, SAID)),
  }));
  const untold = { name: "a breach is seen: another volume to the command line", findings: missedBy(findings(ROW, TRUTH, RIGHT, "a body of 0.4 cm³")) };
  return [{ name: "what is right is found to be right", findings: findings(ROW, TRUTH, RIGHT, SAID) }, untold, ...unseen];
}

/** @param {string[]} found */
function missedBy(found) {
  return found.length > 0 ? [] : ["the judge found nothing"];
}
