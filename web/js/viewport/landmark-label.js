import { language } from "../words/words.js";

/** @typedef {import("./workbench.js").Studio} Studio */

/**
 * What a landmark is called on the page, such as "nose tip · 1".
 *
 * @param {Studio} studio
 * @param {number} landmark
 */
export function landmarkLabel(studio, landmark) {
  return studio.landmarkLabel(landmark, language());
}
