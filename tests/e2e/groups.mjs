import { readFile } from "node:fs/promises";
import { asJpeg, twice } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** @typedef {import("./visitor.mjs").Visitor} Visitor */

/** Button of the earlier face that was shown last. */
export const PREVIOUS_FACE = "#earlier-options button:first-child";

/** Opens a photo with two faces. @param {Visitor} visitor */
export async function openGroup(visitor, name = "group.png") {
  await visitor.drop(await twice(visitor.page, await readFile(SAMPLE)), name);
  await visitor.page.waitForSelector("#face-choice:not([hidden])");
  await visitor.untilFace();
}

/**
 * Chooses a face of the group by its index in the strip.
 *
 * @param {Visitor} visitor
 * @param {number} index in the strip
 */
export function chooseFace({ page }, index) {
  return page.locator("#face-options input").nth(index).click({ force: true });
}

/** Opens a photo whose mesh differs from the sample's. @param {Visitor} visitor @param {string} name */
export async function openOther(visitor, name = "other.jpg") {
  await visitor.drop(await asJpeg(visitor.page, await readFile(SAMPLE), { width: 640, height: 480 }), name);
  await visitor.untilFace();
}
