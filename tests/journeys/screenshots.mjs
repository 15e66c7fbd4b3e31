// Takes the pictures of the documentation, docs/images/*.png, from the built page.
import { mkdir, writeFile } from "node:fs/promises";
import path from "node:path";
import { launch } from "./browser.mjs";
import { DIST, serve } from "./server.mjs";
import { Visitor } from "./visitor.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const IMAGES = path.join(ROOT, "docs/images");
const DESKTOP = { viewport: { width: 1440, height: 900 } };

/** @type {Record<string, { options: object, act: (visitor: Visitor) => Promise<void> }>} */
const PICTURES = {
  "empty-light": { options: { ...DESKTOP, colorScheme: "light" }, act: async () => {} },
  "edit-light": { options: { ...DESKTOP, colorScheme: "light" }, act: work },
  response: { options: { ...DESKTOP, colorScheme: "light" }, act: (visitor) => paint(visitor, "response") },
  distortion: { options: { ...DESKTOP, colorScheme: "light" }, act: (visitor) => paint(visitor, "distortion") },
  "face-light": { options: { ...DESKTOP, colorScheme: "light" }, act: shape },
  "size-light": { options: { ...DESKTOP, colorScheme: "light" }, act: measure },
  "paper-dark": { options: { ...DESKTOP, colorScheme: "dark" }, act: paper },
  "clay-dense-dark": { options: { ...DESKTOP, colorScheme: "dark" }, act: clay },
};

const wanted = process.argv.slice(2);
const server = await serve(DIST, "/");
const browser = await launch();
await mkdir(IMAGES, { recursive: true });
for (const [name, { options, act }] of Object.entries(PICTURES)) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const visitor = await Visitor.arrive(browser, server.url, options);
  await visitor.untilLoaded();
  await act(visitor);
  await visitor.page.evaluate(() => document.activeElement?.blur());
  await visitor.frames(5);
  await writeFile(path.join(IMAGES, `${name}.png`), await visitor.page.screenshot());
  visitor.checkNothingBroke();
  await visitor.leave();
  console.log(`docs/images/${name}.png`);
}
await browser.close();
server.close();

/** @param {Visitor} visitor */
async function measure(visitor) {
  await visitor.dropSample();
  await visitor.findLandmark("right mouth corner");
  await visitor.unfold("section-size");
  await visitor.page.click("[data-action=tape-start]");
  await visitor.findLandmark("left mouth corner");
  await visitor.unfold("section-size");
  await visitor.page.locator("#section-size").evaluate((section) => section.scrollIntoView());
}

/** @param {Visitor} visitor */
async function edit(visitor) {
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 8);
  await visitor.offset("y", -3);
}

/**
 * @param {Visitor} visitor
 * @param {string} name
 */
async function paint(visitor, name) {
  await edit(visitor);
  await visitor.unfold("section-view");
  await visitor.page.check(`input[name="shading"][value="${name}"]`, { force: true });
}

/** @param {Visitor} visitor */
async function work(visitor) {
  await edit(visitor);
  await foldAllBut(visitor, ["section-photo", "section-landmark", "section-history"]);
}

/** @param {Visitor} visitor */
async function shape(visitor) {
  await visitor.dropSample();
  await visitor.slide("nose-width", -2);
  await visitor.slide("eye-size", 1.5);
  await visitor.slide("jaw-width", -4);
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
  await visitor.unfold("section-view");
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
