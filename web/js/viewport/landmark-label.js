import { language } from "../words/words.js";

/** @typedef {import("./workbench.js").Studio} Studio */

/**
 * What a landmark is called on the page, such as "nose tip · 1".
 *
 * @param {Studio} studio
 * @param {number} landmark
 */
export function landmarkLabel(studio, landmark) {
  const name = studio.landmarkName(landmark, language());
  // Landmarks without a name of their own bring their number along.
  const number = ` ${landmark}`;
  return `${name.endsWith(number) ? name.slice(0, -number.length) : name} · ${landmark}`;
}
