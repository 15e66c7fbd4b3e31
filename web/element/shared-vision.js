import { Replaced, VisionClient } from "../js/photo/vision-client.js";
import { noFace } from "../js/page/page-error.js";
import { facesOf } from "../js/work/work.js";

/** @typedef {import("../js/worker/protocol.js").Stage} Stage */

/** One worker for all elements of a page, as its networks are the largest part of Rosto. */
const vision = new VisionClient();
let borrowers = 0;
/** Queue: in {@link VisionClient}, a newer photo would cancel another element's. @type {Promise<unknown>} */
let last = Promise.resolve();

/** Returns the shared worker, which is reference-counted: call {@link returnVision} when done. */
export function borrowVision() {
  borrowers += 1;
  return vision;
}

export function returnVision() {
  borrowers -= 1;
  if (borrowers === 0) vision.end();
}

/**
 * Finds the faces in a photo, most prominent first.
 *
 * @param {Blob} photo
 * @param {string} name
 * @param {(stage: Stage | "loading", fraction: number) => void} report
 * @param {() => boolean} isWanted checked when the queue reaches the photo
 */
export async function facesIn(photo, name, report, isWanted) {
  report("loading", 0);
  const search = last.then(() => {
    if (!isWanted()) throw new Replaced();
    return vision.find(photo, undefined, report);
  });
  last = search.catch(() => {});
  const found = await search;
  found.bitmap.close();
  const faces = facesOf(found, name, photo);
  if (faces.length === 0) throw noFace();
  return faces;
}
