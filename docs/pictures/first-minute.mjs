// The first minute on the page, with a mouse and with animations.
import { STATES, allowDelayedReplies } from "../../tests/e2e/states.mjs";
import { Visitor } from "../../tests/e2e/visitor.mjs";
import { writeSheet } from "./sheet.mjs";

/** @typedef {{ x: number, y: number }} Place CSS px of the window */

const WINDOW = { width: 1280, height: 800 };
/** Frame time at which the opening animation has turned the face furthest. */
const TURNED_MS = 1600;
const STEP_MS = 100;

/** A caption, and the action before its picture, which returns the pointer's place. @type {[string, (visitor: Visitor) => Promise<Place | void>][]} */
const STEPS = [
  ["Open the page. There is nothing to install and no account.", (visitor) => visitor.untilLoaded()],
  ["Drop a photo. It stays on the device.", (visitor) => state("working").enter(visitor)],
  ["The photo becomes a mesh, which turns a little …", seeItArrive],
  ["… and back. A dot marks a place to start.", seeItThere],
  ["Drag the nose: the skin around it follows.", dragNose],
  ["Drag next to the face to turn it.", turn],
  ["Or move a slider.", slide],
  ["Show the edit in the photo: before and after.", compareInPhoto],
  ["Download a GLB for 3D programs.", download],
];

/** @param {import("@playwright/test").Browser} browser @param {string} file @param {string} url */
export async function drawFirstMinute(browser, file, url) {
  const visitor = await Visitor.open(browser, url, {
    viewport: WINDOW, reducedMotion: "no-preference", colorScheme: "light",
    before: async (context) => {
      await allowDelayedReplies(context);
      await context.addInitScript(holdFrames);
    },
  });
  const cells = [];
  for (const [caption, act] of STEPS) {
    const at = await act(visitor);
    const pointer = at && { left: at.x / WINDOW.width, top: at.y / WINDOW.height };
    cells.push({ picture: await visitor.page.screenshot(), caption: `${cells.length + 1}. ${caption}`, pointer });
  }
  visitor.assertNoErrors();
  await visitor.leave();
  await writeSheet(browser, file, cells, { columns: 3, width: 640 });
}

/** @param {string} id */
function state(id) {
  return STATES.find((state) => state.id === id);
}

/** Steps through the animation frame by frame, since a screenshot takes longer than the whole animation. @param {Visitor} visitor */
async function seeItArrive(visitor) {
  const hold = (/** @type {number} */ ms) => visitor.page.evaluate((ms) => window["holdFramesAfter"](ms), ms);
  await hold(0);
  await state("working").leave(visitor);
  for (let ms = 0; ms <= TURNED_MS; ms += STEP_MS) {
    await hold(ms);
    await visitor.frames(3);
  }
}

/** Runs in the page before its scripts. `holdFramesAfter(ms)` stops the frame clock that long after the face appears. */
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

/** Moves the pointer down the middle of the face until the nose tip is highlighted. @param {Visitor} visitor @returns {Promise<Place>} */
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
  throw new Error("the nose tip is not highlighted");
}

/** @param {Visitor} visitor */
async function turn(visitor) {
  await visitor.page.mouse.up();
  const from = await visitor.emptyPoint();
  return hold(visitor, from, { x: from.x + 130, y: from.y + 10 });
}

/** @param {Visitor} visitor */
async function slide(visitor) {
  const { page } = visitor;
  await page.mouse.up();
  await page.click("#toolbar [data-action='reset-view']");
  await visitor.unfold("section-face");
  const slider = page.locator("#slider-jaw-width input[type=range]");
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

/** Drags without releasing the button. @param {Visitor} visitor @param {Place} from @param {Place} to */
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
