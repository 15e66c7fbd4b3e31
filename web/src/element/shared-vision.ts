import { VisionClient } from "../photo/vision-client.ts";

/** One worker for all elements of a page, as its networks are the largest part of Rosto. */
const vision = new VisionClient();
let borrowers = 0;

/** Returns the shared worker, which is reference-counted: call {@link returnVision} when done. */
export function borrowVision() {
  borrowers += 1;
  return vision;
}

export function returnVision() {
  borrowers -= 1;
  if (borrowers === 0) vision.end();
}
