import { PNG } from "pngjs";
import { over } from "./boxes.mjs";

/** Minimum width of the chin, in CSS px. */
const CHIN_PX = 16;

/**
 * Elements over the chin of a frontal face, and edges where the face leaves the stage. Needs screenshots of the 3D view
 * and a face displayed with its photo.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @returns {Promise<string[]>}
 */
export async function chinFindings(visitor) {
  const { page } = visitor;
  const stage = page.locator("#viewport");
  await page.evaluate(showOthers, "hidden");
  // The photo behind the face is the same in both.
  const [clay, coloured] = [await shotOf(visitor, "clay"), await shotOf(visitor, "picture")];
  await page.evaluate(showOthers, "");
  const { x, y, width, height } = await stage.boundingBox();
  const rows = rowsOfFace(clay, coloured);
  if (rows.length === 0) return ["no face is seen"];
  const { row, from, to } = rows.at(-1);
  const chin = { left: x + from, right: x + to, top: y + row - 4, bottom: y + row + 1 };
  const found = (await over(page, chin)).map((name) => `${name} lies over the chin`);
  if (rows[0].row <= 1) found.push("the face leaves the stage above");
  if (row + 1 >= height - 1) found.push("the face leaves the stage below");
  if (rows.some(({ from, to }) => from <= 1 || to >= width - 1)) found.push("the face leaves the stage sideways");
  return found;
}

/** The stage with the face in a shading. @param {import("./visitor.mjs").Visitor} visitor @param {string} shading */
async function shotOf(visitor, shading) {
  const { page } = visitor;
  await page.locator(`input[name="shading"][value="${shading}"]`).evaluate((input) => input.click());
  await visitor.frames(3);
  return PNG.sync.read(await page.locator("#viewport").screenshot({ scale: "css" }));
}

/** Part of each row where two pictures differ. @param {import("./pixels.mjs").Pixels} one @param {import("./pixels.mjs").Pixels} other */
function rowsOfFace(one, other) {
  const rows = [];
  for (let row = 0; row < one.height; row++) {
    const at = (x) => 4 * (row * one.width + x);
    const columns = Array.from({ length: one.width }, (_, x) => x).filter((x) => [0, 1, 2].some((channel) => one.data[at(x) + channel] !== other.data[at(x) + channel]));
    if (columns.length >= CHIN_PX) rows.push({ row, from: columns[0], to: columns.at(-1) + 1 });
  }
  return rows;
}

/** Runs in the page. @param {"" | "hidden"} visibility of everything but the 3D view */
function showOthers(visibility) {
  for (const element of document.querySelectorAll(".stage > :not(.viewport), .panel, #toast, #faces")) element.style.visibility = visibility;
}
