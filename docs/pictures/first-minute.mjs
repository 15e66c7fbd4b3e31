// The first minute on the page, on a desktop and on a phone.
import path from "node:path";
import { STATES, allowDelayedReplies } from "../../tests/e2e/states.mjs";
import { Visitor } from "../../tests/e2e/visitor.mjs";
import { writeSheet } from "./sheet.mjs";

/** @typedef {{ x: number, y: number }} Place CSS px of the window */
/** A caption, and the action before its picture, which returns the pointer's place. @typedef {[string, (visitor: Visitor) => Promise<Place | void>]} Step */

/** Time after which a fade or a hint's change has ended. */
const REST_MS = 1500;

/** @type {Record<string, { visit: import("@playwright/test").BrowserContextOptions, columns: number, width: number, steps: Step[] }>} */
const MINUTES = {
  "first-minute": {
    visit: { viewport: { width: 1280, height: 800 } },
    columns: 3,
    width: 640,
    steps: [
      ["Open the page. There is nothing to install and no account.", (visitor) => visitor.untilLoaded()],
      ["Drop a photo. It stays on the device.", (visitor) => state("working").enter(visitor)],
      ["The 3D face appears next to the photo.", arrive],
      ["Drag next to the face to turn it.", turn],
      ["Drag the nose: the skin around it follows.", dragNose],
      ["Or move a slider.", (visitor) => slide(visitor, 0.8)],
      ["Show the edits in the photo, before and after.", compareInPhoto],
      ["Save the photo, or share it.", (visitor) => rest(visitor, "#save-main")],
      ["Or download the 3D model as a GLB, for other programs.", openMenu],
    ],
  },
  "first-minute-phone": {
    visit: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
    columns: 4,
    width: 480,
    steps: [
      ["Open the page.", (visitor) => visitor.untilLoaded()],
      ["Choose a photo: the 3D face appears in it.", (visitor) => state("working").enter(visitor).then(() => arrive(visitor))],
      ["Move a slider.", (visitor) => slide(visitor, 0.9)],
      ["Save or share the edited photo.", openMenu],
    ],
  },
};

/** @param {import("@playwright/test").Browser} browser @param {string} file named as one of the minutes @param {string} url */
export async function drawFirstMinute(browser, file, url) {
  const { visit, steps, ...layout } = MINUTES[path.parse(file).name];
  const visitor = await Visitor.open(browser, url, { ...visit, reducedMotion: "no-preference", colorScheme: "light", before: allowDelayedReplies });
  const cells = [];
  for (const [caption, act] of steps) {
    const at = await act(visitor);
    const pointer = at && { left: at.x / visit.viewport.width, top: at.y / visit.viewport.height };
    cells.push({ picture: await visitor.page.screenshot(), caption: `${cells.length + 1}. ${caption}`, pointer });
  }
  visitor.assertNoErrors();
  await visitor.leave();
  await writeSheet(browser, file, cells, layout);
}

/** @param {string} id */
function state(id) {
  return STATES.find((state) => state.id === id);
}

/** @param {Visitor} visitor */
async function arrive(visitor) {
  await state("working").leave(visitor);
  await visitor.page.waitForTimeout(REST_MS);
}

/** @param {Visitor} visitor */
async function turn(visitor) {
  const from = await visitor.emptyPoint();
  return hold(visitor, from, { x: from.x + 130, y: from.y + 10 });
}

/** @param {Visitor} visitor */
async function dragNose(visitor) {
  await visitor.page.mouse.up();
  await visitor.page.click("#toolbar [data-action='reset-view']");
  await visitor.page.waitForTimeout(REST_MS);
  const nose = await visitor.landmarkPosition(1);
  await visitor.selectBy("region");
  return hold(visitor, nose, { x: nose.x, y: nose.y - 26 });
}

/** Moves the slider of the nose's width to a share of its track. @param {Visitor} visitor @param {number} share */
async function slide(visitor, share) {
  const { page } = visitor;
  await page.mouse.up();
  const slider = page.locator("#slider-nose-width input[type=range]");
  const { x, y, width, height } = await slider.boundingBox();
  const to = await hold(visitor, { x: x + width / 2, y: y + height / 2 }, { x: x + share * width, y: y + height / 2 });
  await page.waitForTimeout(REST_MS);
  return to;
}

/** @param {Visitor} visitor */
async function compareInPhoto(visitor) {
  await visitor.page.mouse.up();
  await visitor.page.click("#photo-pane");
  await visitor.page.waitForTimeout(REST_MS);
  await state("compare").enter(visitor);
  return middleOf(visitor.page.locator("#compare"));
}

/** @param {Visitor} visitor @param {string} target */
async function rest(visitor, target) {
  await state("compare").leave(visitor);
  const at = await middleOf(visitor.page.locator(target));
  await visitor.page.mouse.move(at.x, at.y);
  return at;
}

/** @param {Visitor} visitor */
async function openMenu(visitor) {
  await visitor.page.mouse.up();
  await visitor.page.click("#save-more");
  return middleOf(visitor.page.locator("#save-popover [data-action='download-glb']"));
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
