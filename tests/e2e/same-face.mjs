import assert from "node:assert/strict";
import { changedProject, partsOfGlb } from "./changed-files.mjs";
import { glbByCommandLine } from "./command-line.mjs";
import { SAMPLE } from "./visitor.mjs";

const LOCAL_FILE = 0x04034b50;

/** What the page has and the command line does not by itself. */
export const AS_THE_PAGE = ["--topology", "canonical", "--units", "mm"];

/**
 * Opens the sample with the landmarks that the command line finds in it, bit for bit. The two compilations of the networks
 * round differently; from there on, the same pixels and the same edits give the same bytes.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 */
export async function openAsCommandLine(visitor) {
  await visitor.drop(await projectAsCommandLine(visitor.project), "portrait.rosto");
  await visitor.untilFace();
}

/** The same as a project. @param {Buffer} project of the page's */
export async function projectAsCommandLine(project) {
  const { landmarks, colours, lens } = partsOfGlb(await glbByCommandLine(SAMPLE, AS_THE_PAGE)).json.scenes[0].extras;
  const face = Buffer.concat([landmarks, colours].map((text) => Buffer.from(text, "base64")));
  const changed = changedProject(project, (header) => ({ ...header, lens }));
  const start = changed.indexOf("\n") + 1;
  const { points } = JSON.parse(changed.subarray(0, start).toString());
  assert.equal(face.length, 12 * points + 3 * 468);
  return Buffer.concat([changed.subarray(0, start), face, changed.subarray(start + face.length)]);
}

/** The files in an archive that is not compressed, by their names. @param {Buffer} zip @returns {Map<string, Buffer>} */
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
