// The number of actions from a photo to each result.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { validateGlb } from "./validate-glb.mjs";

/** @typedef {import("@playwright/test").Page} Page */

const DEVICES = {
  desktop: { viewport: { width: 1280, height: 720 } },
  phone: { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true },
};

/** @type {Record<string, { most: number, actions: ((page: Page) => Promise<unknown>)[], check: (file: Buffer, name: string) => unknown }>} */
const GOALS = {
  "the edited photo": {
    most: 4,
    actions: [choosePhoto, moveSlider, (page) => page.click("#save-more"), (page) => page.click("#save-popover [data-action='download-photo-jpeg']")],
    check: (file, name) => assert.ok(name.endsWith("-edited.jpg") && file.readUInt16BE(0) === 0xffd8, name),
  },
  "a print of 80 mm": {
    most: 4,
    actions: [choosePhoto, (page) => page.click("#save-more"), (page) => page.click("#save-popover [data-action='open-print']"), (page) => page.click("[data-action='download-stl']")],
    check: (file) => assert.ok(Math.abs(heightOf(file) - 80) < 0.1, `${heightOf(file)} mm high`),
  },
  "a GLB": {
    most: 2,
    actions: [choosePhoto, (page) => page.click("#save-main")],
    check: async (file) => assert.deepEqual((await validateGlb(file)).messages, []),
  },
};

for (const [goal, { most, actions, check }] of Object.entries(GOALS)) {
  for (const [device, visit] of Object.entries(DEVICES)) {
    test(`from a photo to ${goal} takes ${most} actions: ${device}`, async ({ open }) => {
      const visitor = await open(visit);
      const { page } = visitor;
      await visitor.untilLoaded();
      assert.ok(actions.length <= most);
      const [first, ...further] = actions;
      await first(page);
      await visitor.untilFace();
      const download = page.waitForEvent("download");
      for (const act of further) await act(page);
      const saved = await download;
      await check(await readFile(await saved.path()), saved.suggestedFilename());
    });
  }
}

test("the first slider and the sliders of a point are visible without scrolling, and about twelve controls at first", async ({ open }) => {
  for (const [device, visit] of Object.entries(DEVICES)) {
    const visitor = await open(visit);
    await visitor.openFace();
    const { page } = visitor;
    const lower = page.locator("#slider-nose-width");
    const box = await lower.boundingBox();
    const save = await page.locator("#save").boundingBox();
    assert.ok(box && box.y + box.height <= save.y, `${device}: the slider is at ${box?.y} px`);
    if (device === "desktop") {
      const z = await page.locator("#landmark-z").boundingBox();
      assert.ok(z && z.y + z.height <= save.y, `z is at ${z?.y} px`);
    } else {
      const stage = await page.locator("#stage").boundingBox();
      assert.ok(stage.height >= 0.6 * visit.viewport.height, `the stage is ${stage.height} px high`);
    }
    const controls = await page.locator("#sections :is(.slider, .choice, .chips, .select, .text-field, .row > .button, .check:not(.chips *)):visible").count();
    assert.ok(controls <= 14, `${device}: ${controls} controls`);
    await visitor.leave();
  }
});

/** @param {Page} page */
async function choosePhoto(page) {
  // The visitor answers each file dialog with the sample.
  await page.click("#welcome [data-action='choose']");
}

/** @param {Page} page */
async function moveSlider(page) {
  const slider = page.locator("#slider-nose-width input[type=range]");
  const { x, y, width, height } = await slider.boundingBox();
  await page.mouse.click(x + 0.8 * width, y + height / 2);
}

/** Height of a binary STL. @param {Buffer} stl */
function heightOf(stl) {
  const heights = [];
  for (let triangle = 0; triangle < stl.readUInt32LE(80); triangle += 1) {
    for (const corner of [12, 24, 36]) heights.push(stl.readFloatLE(84 + 50 * triangle + corner + 4));
  }
  return heights.reduce((most, y) => Math.max(most, y), -Infinity) - heights.reduce((least, y) => Math.min(least, y), Infinity);
}
