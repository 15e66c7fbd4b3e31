import { showLoading, showStage } from "../page/progress.js";
import { noFace } from "../page/page-error.js";
import { facesOf } from "../work/work.js";

/**
 * Finds the faces in a photo, most prominent first, and shows the progress while `isWanted` returns true.
 *
 * @param {import("./vision-client.js").VisionClient} vision
 * @param {Blob} photo
 * @param {string} name
 * @param {() => boolean} isWanted
 * @returns {Promise<import("../work/incoming.js").Incoming>}
 */
export async function readPhoto(vision, photo, name, isWanted) {
  showLoading();
  // Measure from the first progress report, so that loading the worker does not count.
  let begun_ms = NaN;
  const found = await vision.find(photo, undefined, (stage, fraction) => {
    if (Number.isNaN(begun_ms)) begun_ms = performance.now();
    if (isWanted()) showStage(stage, fraction);
  });
  const faces = facesOf(found, name, photo);
  const [face] = faces;
  if (!face) throw noFace();
  return { face, faces, isDoubtful: found.faces[0]?.isDoubtful === true, bitmap: found.bitmap, extraction_ms: performance.now() - begun_ms };
}
