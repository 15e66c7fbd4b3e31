// The sample portrait with three edits in the photo, before and after: docs/images/in-photo.jpg, from the built page.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { launch } from "./browser.mjs";
import { asJpeg } from "./pictures.mjs";
import { DIST, serve } from "./server.mjs";
import { writeSheet } from "./sheets.mjs";
import { SAMPLE, Visitor } from "./visitor.mjs";

/** The portrait is enlarged, so that its face is as large as in a selfie. */
const ENLARGED = { width: 2048, height: 1536 };
/** The head in it, px. */
const PART = { x: 460, y: 60, width: 840, height: 840 };
const SHOWN_PX = 420;

/** @type {[string, Record<string, number>][]} */
const EDITS = [
  ["A narrower, shorter nose", { "nose-width": -4, "nose-length": -3 }],
  ["A narrower jaw, a longer chin", { "jaw-width": -8, "chin-length": 5 }],
  ["Larger eyes, higher brows, fuller lips", { "eye-size": 2, "brow-height": 4, "lip-fullness": 2 }],
];

const file = path.resolve(import.meta.dirname, "../../docs/images/in-photo.jpg");
const server = await serve(DIST, "/");
const browser = await launch();
const visitor = await Visitor.arrive(browser, server.url);
await visitor.drop(await asJpeg(visitor.page, await readFile(SAMPLE), ENLARGED), "portrait.jpg");
await visitor.untilFace();
const before = await photo();
const after = [];
for (const [caption, sliders] of EDITS) {
  for (const [slider, amount_mm] of Object.entries(sliders)) await visitor.slide(slider, amount_mm);
  after.push({ picture: await photo(), caption });
  await visitor.unfold("section-history");
  await visitor.page.click("#section-history [data-action='reset']");
}
visitor.checkNothingBroke();
await visitor.leave();
const rows = [after.map(() => ({ picture: before, caption: "Before" })), after];
await writeSheet(browser, file, { rows, width: SHOWN_PX, height: SHOWN_PX });
await browser.close();
server.close();
console.log(path.relative(process.cwd(), file));

/** The part of the photo as the page saves it. */
async function photo() {
  const whole = PNG.sync.read(await visitor.download("download-photo-png"));
  const part = new PNG({ width: PART.width, height: PART.height });
  PNG.bitblt(whole, part, PART.x, PART.y, PART.width, PART.height, 0, 0);
  return PNG.sync.write(part);
}
