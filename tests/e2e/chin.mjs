import { PNG } from "pngjs";
import { over } from "./boxes.mjs";

/** Skin differs in its channels by at least this much, 0 to 255; the page's backgrounds and shadows do not. */
const LEAST_COLOUR = 28;

/** Minimum width of the chin, in CSS px; lines, letters and dots are narrower. */
const CHIN_PX = 16;

/**
 * Elements over the chin of a frontal face, and edges where the face leaves the stage. Needs screenshots of the 3D view
 * and a face displayed with its photo.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @returns {Promise<string[]>}
 */
export async function chinFindings({ page }) {
  const stage = page.locator("#viewport");
  await page.evaluate(showOthers, "hidden");
  const shot = PNG.sync.read(await stage.screenshot({ scale: "css" }));
  await page.evaluate(showOthers, "");
  const { x, y, width, height } = await stage.boundingBox();
  const rows = rowsOfSkin(shot);
  if (rows.length === 0) return ["no face is seen"];
  const { row, from, to } = rows.at(-1);
  const chin = { left: x + from, right: x + to, top: y + row - 4, bottom: y + row + 1 };
  const found = (await over(page, chin)).map((name) => `${name} lies over the chin`);
  if (rows[0].row <= 1) found.push("the face leaves the stage above");
  if (row + 1 >= height - 1) found.push("the face leaves the stage below");
  if (rows.some(({ from, to }) => from <= 1 || to >= width - 1)) found.push("the face leaves the stage sideways");
  return found;
}

/** Longest run of skin in each row. @param {import("./pixels.mjs").Pixels} pixels */
function rowsOfSkin({ width, height, data }) {
  const rows = [];
  for (let row = 0; row < height; row++) {
    let longest = { row, from: 0, to: 0 };
    let from = 0;
    for (let x = 0; x <= width; x++) {
      const at = 4 * (row * width + x);
      if (x < width && isSkin(data.subarray(at, at + 3))) continue;
      if (x - from > longest.to - longest.from) longest = { row, from, to: x };
      from = x + 1;
    }
    if (longest.to - longest.from >= CHIN_PX) rows.push(longest);
  }
  return rows;
}

/** @param {Uint8Array} colour */
function isSkin(colour) {
  return Math.max(...colour) - Math.min(...colour) >= LEAST_COLOUR;
}

/** Runs in the page. @param {"" | "hidden"} visibility of everything but the 3D view */
function showOthers(visibility) {
  for (const element of document.querySelectorAll(".stage > :not(.viewport), .panel, #toast, #faces")) element.style.visibility = visibility;
}
