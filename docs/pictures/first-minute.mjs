// The first minute of somebody new to the page, by mouse and with the motion that visitors see.
import { STATES, withHeldWork } from "../../tests/e2e/states.mjs";
import { Visitor } from "../../tests/e2e/visitor.mjs";
import { writeSheet } from "./sheet.mjs";

/** @typedef {{ x: number, y: number }} Place in CSS px of the window */

const WINDOW = { width: 1280, height: 800 };
/** A face that has arrived is turned furthest after this time, by the clock of the frames. */
const TURNED_MS = 1600;
const STEP_MS = 100;

/** Each caption, and what is done before its picture; returns the place of the pointer. @type {[string, (visitor: Visitor) => Promise<Place | void>][]} */
const STEPS = [
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

/** @param {import("@playwright/test").Browser} browser @param {string} file @param {string} url */
export async function drawFirstMinute(browser, file, url) {
  const visitor = await Visitor.arrive(browser, url, {
    viewport: WINDOW, reducedMotion: "no-preference", colorScheme: "light",
    before: async (context) => {
      await withHeldWork(context);
      await context.addInitScript(holdFrames);
    },
  });
  const cells = [];
  for (const [caption, act] of STEPS) {
    const at = await act(visitor);
    const pointer = at && { left: at.x / WINDOW.width, top: at.y / WINDOW.height };
    cells.push({ picture: await visitor.page.screenshot(), caption: `${cells.length + 1}. ${caption}`, pointer });
  }
  visitor.checkNothingBroke();
  await visitor.leave();
  await writeSheet(browser, file, cells, { columns: 3, width: 640 });
}

/** @param {string} id */
function state(id) {
  return STATES.find((state) => state.id === id);
}

/** A screenshot takes longer than the arrival: its frames come one by one. @param {Visitor} visitor */
async function seeItArrive(visitor) {
  const hold = (/** @type {number} */ ms) => visitor.page.evaluate((ms) => window["holdFramesAfter"](ms), ms);
  await hold(0);
  await state("working").leave(visitor);
  for (let ms = 0; ms <= TURNED_MS; ms += STEP_MS) {
    await hold(ms);
    await visitor.frames(3);
  }
}

/** Runs in the page before its own scripts: `holdFramesAfter` stops the frames' time so long after a face has come. */
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
  return hold(visitor, nose, { x: nose.x, y: nose.y - 26 });
}

/** Moves the pointer down the middle of the face until the nose tip lights up. @param {Visitor} visitor @returns {Promise<Place>} */
async function findNose(visitor) {
  const { page } = visitor;
  const { x, y, width, height } = await page.locator("#viewport").boundingBox();
  const tag = page.locator("#landmark-tag");
  for (let share = 0.35; share < 0.75; share += 0.01) {
    const place = { x: x + width / 2, y: y + share * height };
    await page.mouse.move(place.x, place.y);
    await visitor.frames(2);
    if ((await tag.isVisible()) && (await tag.innerText()).startsWith("nose tip")) return place;
  }
  throw new Error("the nose tip does not light up");
}

/** @param {Visitor} visitor */
async function turn(visitor) {
  await visitor.page.mouse.up();
  const from = await visitor.besideTheFace();
  return hold(visitor, from, { x: from.x + 130, y: from.y + 10 });
}

/** @param {Visitor} visitor */
async function slide(visitor) {
  const { page } = visitor;
  await page.mouse.up();
  await page.click("#toolbar [data-action='reset-view']");
  await visitor.unfold("section-face");
  const slider = page.locator("[data-slider='jaw-width'] input[type=range]");
  await slider.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await slider.boundingBox();
  const to = await hold(visitor, { x: x + width / 2, y: y + height / 2 }, { x: x + width / 5, y: y + height / 2 });
  await page.waitForTimeout(600);
  return to;
}

/** @param {Visitor} visitor */
async function compareInPhoto(visitor) {
  await visitor.page.mouse.up();
  await visitor.page.click("#photo-to-stage");
  await visitor.page.waitForTimeout(1500);
  await state("compare").enter(visitor);
  return middleOf(visitor.page.locator("#compare"));
}

/** @param {Visitor} visitor */
async function download(visitor) {
  await state("compare").leave(visitor);
  await state("downloaded").enter(visitor);
  return middleOf(visitor.page.locator("[data-action='download-glb']:visible").first());
}

/** Presses the mouse and moves it; it stays down. @param {Visitor} visitor @param {Place} from @param {Place} to */
async function hold(visitor, from, to) {
  await visitor.page.mouse.move(from.x, from.y);
  await visitor.page.mouse.down();
  await visitor.page.mouse.move(to.x, to.y, { steps: 6 });
  await visitor.frames(3);
  return to;
}

/** @param {import("@playwright/test").Locator} locator @returns {Promise<Place>} */
async function middleOf(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2 };
}
