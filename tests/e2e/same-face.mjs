import assert from "node:assert/strict";
import { changedProject, partsOfGlb } from "./changed-files.mjs";
import { glbByCommandLine } from "./command-line.mjs";
import { SAMPLE } from "./visitor.mjs";

const LOCAL_FILE = 0x04034b50;

/** Options that make the command line write what the page does. */
export const PAGE_OPTIONS = ["--topology", "canonical", "--units", "mm"];

/**
 * Opens the sample with the landmarks of the command line, bit for bit. The native and wasm builds of the networks round
 * differently; after that, equal pixels and edits give equal bytes.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 */
export async function openAsCommandLine(visitor) {
  await visitor.drop(await projectAsCommandLine(visitor.project), "portrait.rosto");
  await visitor.untilFace();
}

/** A project with the command line's landmarks. @param {Buffer} project saved by the page */
export async function projectAsCommandLine(project) {
  const [{ observation }] = partsOfGlb(await glbByCommandLine(SAMPLE, PAGE_OPTIONS)).json.scenes[0].extras.photos;
  return changedProject(project, ({ photos: [photo] }) => {
    assert.equal(observation.length, photo.observation.length);
    photo.observation = observation;
  });
}

/** Files of an uncompressed archive by name. @param {Buffer} zip @returns {Map<string, Buffer>} */
export function storedFiles(zip) {
  const files = new Map();
  for (let at = 0; zip.readUInt32LE(at) === LOCAL_FILE; ) {
    const [bytes, name, extra] = [zip.readUInt32LE(at + 18), zip.readUInt16LE(at + 26), zip.readUInt16LE(at + 28)];
    const start = at + 30 + name + extra;
    files.set(zip.toString("utf8", at + 30, at + 30 + name), zip.subarray(start, start + bytes));
    at = start + bytes;
  }
  return files;
}
