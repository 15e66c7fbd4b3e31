import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { chromaticity, colourCount, meanColour } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

/** The middle of the face, in the portrait and on the canvas. */
const FACE_IN_PORTRAIT = { left: 0.4, top: 0.17, right: 0.47, bottom: 0.3 };
const FACE_ON_CANVAS = { left: 0.46, top: 0.42, right: 0.54, bottom: 0.58 };

/** Asserts that the view shows the sample's face in its colours. @param {import("./pixels.mjs").Pixels} view */
export async function assertPortraitColours(view) {
  assert.ok(colourCount(view) > 40, `only ${colourCount(view)} colours on the canvas`);
  const wanted = chromaticity(meanColour(PNG.sync.read(await readFile(SAMPLE)), FACE_IN_PORTRAIT));
  const seen = chromaticity(meanColour(view, FACE_ON_CANVAS));
  for (const [channel, share] of seen.entries()) {
    assert.ok(Math.abs(share - wanted[channel]) < 0.04, `colours ${seen} are far from the portrait's ${wanted}`);
  }
}
