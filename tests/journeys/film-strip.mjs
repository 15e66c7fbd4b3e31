// The first minute of somebody new to the built page, as a strip of pictures: docs/images/first-minute.jpg, or the file
// named. Everything is done by mouse, and moves as it does for visitors.
import path from "node:path";
import { launch } from "./browser.mjs";
import { Hand } from "./hand.mjs";
import { DIST, serve } from "./server.mjs";
import { writeSheet } from "./sheets.mjs";
import { STATES, withHeldWork } from "./states.mjs";
import { Visitor } from "./visitor.mjs";

/** @typedef {import("./hand.mjs").Place} Place */

const WINDOW = { width: 1280, height: 800 };
const PER_ROW = 3;
/** When a face that has come is turned furthest, before it turns back, by the clock of the frames. */
const TURNED_MS = 1600;
const STEP_MS = 100;

/** What is done, and where the pointer is at its end. @type {[string, (visitor: Visitor) => Promise<Place | void>][]} */
const FRAMES = [
  ["Open the page. Nothing is asked for, nothing to install.", (visitor) => visitor.untilLoaded()],
  ["Drop a photo. It is read here, on the device.", (visitor) => state("working").enter(visitor)],
  ["The photo lifts into a mesh, which turns a little …", seeItArrive],
  ["… and back. A dot says where to begin.", seeItThere],
  ["Drag the nose: what is around it follows.", dragNose],
  ["Let go, and drag beside the face to turn it.", turn],
  ["Or move a ready-made slider.", slide],
  ["The photo follows: one press gives it the stage. Before and after.", compareInPhoto],
  ["Download: a GLB for any 3D program.", download],
];

const file = path.resolve(process.argv[2] ?? path.join(import.meta.dirname, "../../docs/images/first-minute.jpg"));
const server = await serve(DIST, "/");
const browser = await launch();
const visitor = await Visitor.arrive(browser, server.url, {
  viewport: WINDOW, reducedMotion: "no-preference", colorScheme: "light",
  before: async (context) => {
    await withHeldWork(context);
    await context.addInitScript(holdFrames);
  },
});
const cells = [];
for (const [place, [caption, act]] of FRAMES.entries()) {
  const pointer = await act(visitor);
  const picture = await visitor.page.screenshot();
  cells.push({ picture, caption: `${place + 1}. ${caption}`, pointer: pointer && { left: pointer.x / WINDOW.width, top: pointer.y / WINDOW.height } });
}
visitor.checkNothingBroke();
await visitor.leave();
const rows = Array.from({ length: Math.ceil(cells.length / PER_ROW) }, (_, row) => cells.slice(PER_ROW * row, PER_ROW * (row + 1)));
await writeSheet(browser, file, { rows, width: 640, height: 400, most_bytes: 800_000 });
await browser.close();
server.close();
console.log(path.relative(process.cwd(), file));

/** @param {string} id */
function state(id) {
  const found = STATES.find((state) => state.id === id);
  if (!found) throw new Error(`no state ${id}`);
  return found;
}

/** A picture takes longer than the arrival, whose frames wait for it: they come one by one. @param {Visitor} visitor */
async function seeItArrive(visitor) {
  const hold = (/** @type {number} */ ms) => visitor.page.evaluate((ms) => window["holdFramesAfter"](ms), ms);
  await hold(0);
  await state("working").leave?.(visitor);
  for (let ms = 0; ms <= TURNED_MS; ms += STEP_MS) {
    await hold(ms);
    await visitor.frames(3);
  }
}

/** Runs in the page before its own scripts: once asked, the frames' time stands still so long after a face has come. */
function holdFrames() {
  const ask = window.requestAnimationFrame.bind(window);
  let most_ms = Number.POSITIVE_INFINITY;
  let since_ms = Number.NaN;
  let late_ms = 0;
  window.requestAnimationFrame = (draw) => ask((time_ms) => draw(timeFor(time_ms)));
  const timeFor = (/** @type {number} */ time_ms) => {
    if (document.body.dataset["state"] === "face" && Number.isNaN(since_ms)) since_ms = time_ms;
    const last_ms = Number.isNaN(since_ms) ? time_ms : since_ms + most_ms;
    late_ms = Math.max(late_ms, time_ms - last_ms);
    return time_ms - late_ms;
  };
  window["holdFramesAfter"] = (ms) => {
    most_ms = ms;
  };
}

/** @param {Visitor} visitor */
async function seeItThere(visitor) {
  await visitor.page.evaluate(() => window["holdFramesAfter"](Number.POSITIVE_INFINITY));
  await visitor.page.waitForSelector("#hint");
  await visitor.page.waitForTimeout(1500);
}

/** @param {Visitor} visitor */
async function dragNose(visitor) {
  const nose = await findNose(visitor);
  const hand = await Hand.of(visitor);
  const to = { x: nose.x, y: nose.y - 26 };
  await hand.press(nose);
  await hand.move(nose, to);
  await visitor.frames(3);
  return to;
}

/** Feels for the nose with the pointer, down the middle of the face. @param {Visitor} visitor @returns {Promise<Place>} */
async function findNose(visitor) {
  const { x, y, width, height } = await visitor.page.locator("#viewport").boundingBox();
  for (let share = 0.35; share < 0.75; share += 0.01) {
    await visitor.page.mouse.move(x + width / 2, y + share * height);
    await visitor.frames(2);
    const tag = visitor.page.locator("#landmark-tag");
    if ((await tag.isVisible()) && (await tag.innerText()).startsWith("nose tip")) return { x: x + width / 2, y: y + share * height };
  }
  throw new Error("no nose is felt");
}

/** @param {Visitor} visitor */
async function turn(visitor) {
  const hand = await Hand.of(visitor);
  await hand.release();
  const from = await visitor.besideTheFace();
  const to = { x: from.x + 130, y: from.y + 10 };
  await hand.press(from);
  await hand.move(from, to);
  await visitor.frames(3);
  return to;
}

/** @param {Visitor} visitor */
async function slide(visitor) {
  const { page } = visitor;
  const hand = await Hand.of(visitor);
  await hand.release();
  await page.click("#toolbar [data-action='reset-view']");
  await visitor.unfold("section-face");
  const slider = page.locator("[data-slider='jaw-width'] input[type=range]");
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider.boundingBox();
  const from = { x: x + width / 2, y: y + height / 2 };
  const to = { x: x + width / 5, y: from.y };
  await hand.press(from);
  await hand.move(from, to);
  await visitor.page.waitForTimeout(600);
  return to;
}

/** @param {Visitor} visitor */
async function compareInPhoto(visitor) {
  await (await Hand.of(visitor)).release();
  await visitor.page.click("#photo-to-stage");
  await visitor.page.waitForTimeout(1500);
  await state("compare").enter(visitor);
  const { x, y, width, height } = await visitor.page.locator("#compare").boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}

/** @param {Visitor} visitor */
async function download(visitor) {
  await state("compare").leave?.(visitor);
  await state("downloaded").enter(visitor);
  const { x, y, width, height } = await visitor.page.locator("[data-action='download-glb']:visible").first().boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}
