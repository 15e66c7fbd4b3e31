import { Replaced, VisionClient } from "../js/photo/vision-client.js";
import { noFace } from "../js/page/page-error.js";
import { facesOf } from "../js/work/work.js";

/** @typedef {import("../js/worker/protocol.js").Stage} Stage */

/** One worker serves all elements of a page: its networks weigh more than all else. */
const vision = new VisionClient();
let borrowers = 0;
/** Photos are looked at one after the other: for the worker's client a newer one would replace an older. @type {Promise<unknown>} */
let last = Promise.resolve();

/** The worker, which is there until as many have given it back as have borrowed it. */
export function borrowVision() {
  borrowers += 1;
  return vision;
}

export function returnVision() {
  borrowers -= 1;
  if (borrowers === 0) vision.end();
}

/**
 * The faces of a photo, the most prominent first.
 *
 * @param {Blob} photo
 * @param {string} name
 * @param {(stage: Stage | "loading", fraction: number) => void} report
 * @param {() => boolean} isWanted when its turn has come
 */
export async function facesIn(photo, name, report, isWanted) {
  report("loading", 0);
  const looked = last.then(() => {
    if (!isWanted()) throw new Replaced();
    return vision.find(photo, undefined, report);
  });
  last = looked.catch(() => {});
  const found = await looked;
  found.bitmap.close();
  const faces = facesOf(found, name, photo);
  if (faces.length === 0) throw noFace();
  return faces;
}
