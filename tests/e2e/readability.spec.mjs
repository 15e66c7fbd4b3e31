import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { chinFindings } from "./chin.mjs";
import { test } from "./fixtures.mjs";
import { STATES, allowDelayedReplies, problemsOf } from "./states.mjs";

/** States that show most of the page's texts. */
const SEEN = STATES.filter(({ id }) => ["empty", "working", "arrived", "selected", "view", "export", "notice", "keys"].includes(id));

const LARGE_FONTS = [{ font_px: 32, width: 1440, height: 900 }, { font_px: 24, width: 1280, height: 720 }, { font_px: 24, width: 480, height: 900 }];

for (const { font_px, width, height } of LARGE_FONTS) {
  test(`with a font size of ${font_px} px in a window of ${width} × ${height}, texts are larger and nothing is cut`, async ({ open }) => {
    const visitor = await open({ viewport: { width, height }, colorScheme: "light", before: allowDelayedReplies });
    const { page } = visitor;
    const session = await page.context().newCDPSession(page);
    await session.send("Page.setFontSizes", { fontSizes: { standard: font_px } });
    /** Each finding with the first state that has it. @type {Map<string, string>} */
    const found = new Map();
    for (const state of SEEN) {
      await state.enter(visitor);
      for (const language of ["en", "pt"]) {
        await visitor.setLanguage(language);
        for (const what of await problemsOf(visitor, state)) found.set(what, found.get(what) ?? `${state.id}, ${language}`);
        for (const what of await page.evaluate(smallTexts, 0.6875 * font_px)) found.set(what, `${state.id}, ${language}`);
      }
      await state.leave?.(visitor);
    }
    assert.deepEqual([...found], []);
  });
}

for (const [width, height] of [[320, 200], [320, 256], [390, 300]]) {
  test(`in a window of ${width} × ${height}, the face is visible and everything can be scrolled to`, { tag: "@eyes" }, async ({ open }) => {
    const visitor = await open({ viewport: { width, height } });
    const { page } = visitor;
    await visitor.untilLoaded();
    assert.ok((await page.locator("#viewport").boundingBox()).height >= 96);
    for (const button of await page.locator("#welcome button:visible, #panel :is(button, select):visible").all()) await button.click({ trial: true });
    const sideways = () => page.evaluate("document.documentElement.scrollWidth - innerWidth");
    assert.equal(await sideways(), 0);

    await visitor.openFace();
    assert.equal(await page.evaluate("scrollY"), 0);
    for (const control of await page.locator("#toolbar button:enabled:visible, #tab-view, #save-main").all()) await control.click({ trial: true });
    await visitor.setSlider("nose-width", 2);
    await page.click("#panel-foot [data-action='open-credits']");
    await page.keyboard.press("Escape");
    assert.equal(await sideways(), 0);
    await page.evaluate("scrollTo(0, 0)");
    assert.deepEqual(await chinFindings(visitor), []);
    assert.ok((await page.locator("#stage").boundingBox()).height < height, "no part of the panel is in view, by which the page can be scrolled");
  });
}

test("with forced colours, the selected segment and tab, slider tracks and the main button are visible", async ({ open }) => {
  const visitor = await open({ forcedColors: "active" });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.unfold("section-landmark");
  /** @param {string} selector @param {string} property */
  const style = (selector, property) => page.locator(selector).first().evaluate((element, property) => getComputedStyle(element)[property], property);
  const systemColour = (/** @type {string} */ name) => page.evaluate((name) => {
    const element = document.body.appendChild(document.createElement("p"));
    Object.assign(element.style, { color: name, forcedColorAdjust: "none" });
    const { color } = getComputedStyle(element);
    element.remove();
    return color;
  }, name);
  const [highlight, onHighlight, canvas, text] = await Promise.all(["Highlight", "HighlightText", "Canvas", "CanvasText"].map(systemColour));
  const segment = (/** @type {string} */ state) => `.choice-options input${state}:not([disabled]) + span`;
  assert.equal(await style(segment(":checked"), "backgroundColor"), highlight);
  assert.equal(await style(segment(":checked"), "color"), onHighlight);
  assert.notEqual(await style(segment(":not(:checked)"), "backgroundColor"), highlight);
  assert.equal(await style("[role=tab][aria-selected='true']", "borderBottomColor"), highlight);
  assert.equal(await style("[role=tab][aria-selected='false']", "borderBottomColor"), canvas);
  assert.equal(await style("#save-main", "backgroundColor"), highlight);
  assert.equal(await style("#save-main", "color"), onHighlight);

  const slider = page.locator("#slider-nose-width input[type=range]");
  await slider.scrollIntoViewIfNeeded();
  const { data, width, height } = PNG.sync.read(await slider.screenshot());
  const colour = (x, y) => `rgb(${[...data.subarray(4 * (y * width + x)).subarray(0, 3)].join(", ")})`;
  const column = Array.from({ length: height }, (_, y) => colour(Math.floor(width / 8), y));
  assert.ok(column.includes(text) && column.includes(canvas), `the track is not visible: ${[...new Set(column)]}`);
});

/** Runs in the page: visible texts below a size. @param {number} least_px */
function smallTexts(least_px) {
  const texts = [...document.querySelectorAll("body *")].filter((element) => element.checkVisibility() && element.closest("svg, canvas") === null)
    .filter((element) => [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim()));
  const small = texts.filter((element) => Number.parseFloat(getComputedStyle(element).fontSize) < least_px);
  return small.map((element) => `${element.id || element.className || element.tagName} has a font size of ${getComputedStyle(element).fontSize}`);
}
