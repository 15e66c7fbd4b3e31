import { PNG } from "pngjs";
import { over } from "./boxes.mjs";

/** A person's skin is this much more of one colour than of another, 0 to 255; the page's grounds and shadows are not. */
const LEAST_COLOUR = 28;

/** The chin is at least this wide, in CSS px: lines, letters and dots are thinner. */
const CHIN_PX = 16;

/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box */

/**
 * What lies over the chin of a face that is seen from the front, and whether all of the face is on the stage. For browsers
 * whose screenshots show the 3D view, and a face painted with its photo.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @returns {Promise<string[]>}
 */
export async function chinFindings({ page }) {
  const box = await faceBox(page);
  if (!box) return ["no face is seen"];
  const { chin, stage } = box;
  const found = (await over(page, chin)).map((name) => `${name} lies over the chin`);
  if (box.top <= stage.top + 1) found.push("the face leaves the stage above");
  if (chin.bottom >= stage.bottom - 1) found.push("the face leaves the stage below");
  if (box.left <= stage.left + 1 || box.right >= stage.right - 1) found.push("the face leaves the stage sideways");
  return found;
}

/** @param {import("@playwright/test").Page} page */
async function faceBox(page) {
  await showOthers(page, "hidden");
  const shot = PNG.sync.read(await page.locator("#viewport").screenshot({ scale: "css" }));
  await showOthers(page, "");
  const { x, y, width, height } = await page.locator("#viewport").boundingBox();
  const stage = { left: x, top: y, right: x + width, bottom: y + height };
  const rows = rowsOfSkin(shot);
  const [first, last] = [rows.at(0), rows.at(-1)];
  if (!first || !last) return undefined;
  const chin = { left: x + last.from, right: x + last.to, top: y + last.row - 4, bottom: y + last.row + 1 };
  const left = x + Math.min(...rows.map(({ from }) => from));
  const right = x + Math.max(...rows.map(({ to }) => to));
  return { top: y + first.row, left, right, chin, stage };
}

/** The longest run of skin in each row of a picture that has one. @param {import("./pixels.mjs").Pixels} pixels */
function rowsOfSkin({ width, height, data }) {
  const rows = [];
  for (let row = 0; row < height; row++) {
    let longest = { row, from: 0, to: 0 };
    let from = 0;
    for (let x = 0; x <= width; x++) {
      if (x < width && isSkin(data, 4 * (row * width + x))) continue;
      if (x - from > longest.to - longest.from) longest = { row, from, to: x };
      from = x + 1;
    }
    if (longest.to - longest.from >= CHIN_PX) rows.push(longest);
  }
  return rows;
}

/** @param {Uint8Array} data RGBA @param {number} at */
function isSkin(data, at) {
  const channels = [data[at], data[at + 1], data[at + 2]];
  return Math.max(...channels) - Math.min(...channels) >= LEAST_COLOUR;
}

/** @param {import("@playwright/test").Page} page @param {"" | "hidden"} visibility of all but the 3D view */
function showOthers(page, visibility) {
  return page.evaluate((visibility) => {
    for (const element of document.querySelectorAll(".stage > :not(.viewport), .panel, #toast, #faces")) element.style.visibility = visibility;
  }, visibility);
}
