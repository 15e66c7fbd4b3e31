// Screenshots of the built page, and the sample portrait as edited by it.
import { readFile } from "node:fs/promises";
import path from "node:path";
import { asJpeg } from "../../tests/e2e/pictures.mjs";
import { SAMPLE, Visitor } from "../../tests/e2e/visitor.mjs";
import { cut, writeSheet } from "./sheet.mjs";

/** @typedef {import("@playwright/test").Browser} Browser */

const DESKTOP = { viewport: { width: 1440, height: 900 } };

/** Size of the enlarged portrait, whose face is as large as in a selfie, and the box of its head; px. */
const ENLARGED = { width: 2048, height: 1536 };
const HEAD = { x: 460, y: 60, width: 840, height: 840 };

/** @type {[string, Record<string, number>][]} */
const EDITS = [
  ["A narrower, shorter nose", { "nose-width": -4, "nose-length": -3 }],
  ["A narrower jaw, a longer chin", { "jaw-width": -8, "chin-length": 5 }],
  ["Larger eyes, higher brows, fuller lips", { "eye-size": 2, "brow-height": 4, "lip-fullness": 2 }],
];

/** Brings the page into a state; names end with the colour scheme, light by default. @type {Record<string, (visitor: Visitor) => Promise<void>>} */
export const SCREENSHOTS = {
  "empty-light": async () => {},
  "edit-light": async (visitor) => {
    await edit(visitor);
    await foldAllBut(visitor, ["section-photo", "section-landmark", "section-history"]);
  },
  response: (visitor) => paint(visitor, "response"),
  distortion: (visitor) => paint(visitor, "distortion"),
  "face-light": shape,
  "size-light": measure,
  "paper-dark": paper,
  "clay-dense-dark": clay,
};

/** @param {Browser} browser @param {string} file named as one of {@link SCREENSHOTS} @param {string} url */
export async function takeScreenshot(browser, file, url) {
  const { name } = path.parse(file);
  const visitor = await Visitor.open(browser, url, { ...DESKTOP, colorScheme: name.endsWith("-dark") ? "dark" : "light" });
  await visitor.untilLoaded();
  await SCREENSHOTS[name](visitor);
  await visitor.page.evaluate(() => document.activeElement?.blur());
  await visitor.frames(5);
  await visitor.page.screenshot({ path: file });
  visitor.assertNoErrors();
  await visitor.leave();
}

/** The sample portrait with three edits in the photo, before and after. @param {Browser} browser @param {string} file @param {string} url */
export async function drawInPhoto(browser, file, url) {
  const visitor = await Visitor.open(browser, url);
  await visitor.drop(await asJpeg(visitor.page, await readFile(SAMPLE), ENLARGED), "portrait.jpg");
  await visitor.untilFace();
  const photo = async () => cut(await visitor.download("download-photo-png"), HEAD);
  const before = { picture: await photo(), caption: "Before" };
  const after = [];
  for (const [caption, sliders] of EDITS) {
    for (const [slider, amount_mm] of Object.entries(sliders)) await visitor.setSlider(slider, amount_mm);
    after.push({ picture: await photo(), caption });
    await visitor.unfold("section-history");
    await visitor.page.click("#section-history [data-action='reset']");
  }
  visitor.assertNoErrors();
  await visitor.leave();
  await writeSheet(browser, file, [...after.map(() => before), ...after], { columns: after.length, width: 420 });
}

/** @param {Visitor} visitor */
async function measure(visitor) {
  await visitor.dropSample();
  await visitor.findLandmark("right mouth corner");
  await visitor.unfold("section-size");
  await visitor.page.click("[data-action='tape.start']");
  await visitor.findLandmark("left mouth corner");
  await visitor.unfold("section-size");
  await visitor.page.locator("#section-size").evaluate((section) => section.scrollIntoView());
}

/** @param {Visitor} visitor */
async function edit(visitor) {
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.setOffset("z", 8);
  await visitor.setOffset("y", -3);
}

/**
 * @param {Visitor} visitor
 * @param {string} name
 */
async function paint(visitor, name) {
  await edit(visitor);
  await visitor.reveal(`[name="shading"][value="${name}"]`);
  await visitor.page.check(`input[name="shading"][value="${name}"]`, { force: true });
}

/** @param {Visitor} visitor */
async function shape(visitor) {
  await visitor.dropSample();
  await visitor.setSlider("nose-width", -2);
  await visitor.setSlider("eye-size", 1.5);
  await visitor.setSlider("jaw-width", -4);
  await foldAllBut(visitor, ["section-face", "section-history"]);
}

/** @param {Visitor} visitor */
async function paper(visitor) {
  await visitor.dropSample();
  await visitor.unfold("section-paper");
  await foldAllBut(visitor, ["section-advanced", "section-paper"]);
  await visitor.page.click("[data-action='run-paper']");
  await visitor.page.waitForSelector("#paper-results:not([hidden])", { timeout: 150_000 });
  await visitor.page.locator("#paper-results").evaluate((results) => results.scrollIntoView());
}

/** @param {Visitor} visitor */
async function clay(visitor) {
  await visitor.dropSample();
  await visitor.reveal("#density");
  await visitor.page.selectOption("#density", "3");
  await visitor.page.check("input[name='shading'][value='clay']", { force: true });
  await visitor.page.focus("#viewport");
  for (let press = 0; press < 7; press++) await visitor.page.keyboard.press("ArrowRight");
}

/**
 * @param {Visitor} visitor
 * @param {string[]} open
 */
async function foldAllBut(visitor, open) {
  await visitor.page.evaluate((open) => {
    for (const section of document.querySelectorAll("details.section")) section.open = open.includes(section.id);
    document.getElementById("sections").scrollTop = 0;
  }, open);
}
