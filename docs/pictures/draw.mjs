// Redraws docs/images/ from the built page (dist/) and the models: node docs/pictures/draw.mjs [NAME…].
import path from "node:path";
import { launch } from "../../tests/e2e/browser.mjs";
import { DIST, serve } from "../../tests/e2e/server.mjs";
import { drawFirstMinute } from "./first-minute.mjs";
import { drawLandmarks } from "./landmarks.mjs";
import { drawExpressions, drawSlices, drawTextures } from "./models.mjs";
import { drawInPhoto, SCREENSHOTS, takeScreenshot } from "./page.mjs";

const IMAGES = path.resolve(import.meta.dirname, "../images");

/** @type {Record<string, (browser: import("@playwright/test").Browser, file: string, url: string) => Promise<void>>} */
const PICTURES = {
  ...Object.fromEntries(Object.keys(SCREENSHOTS).map((name) => [`${name}.png`, takeScreenshot])),
  "first-minute.jpg": drawFirstMinute,
  "first-minute-phone.jpg": drawFirstMinute,
  "in-photo.jpg": drawInPhoto,
  "landmarks.svg": drawLandmarks,
  "expressions.jpg": drawExpressions,
  "texture.jpg": drawTextures,
  "sliced.jpg": drawSlices,
};

const wanted = process.argv.slice(2);
const server = await serve(DIST, "/");
const browser = await launch();
for (const [name, draw] of Object.entries(PICTURES)) {
  if (wanted.length > 0 && !wanted.includes(path.parse(name).name)) continue;
  await draw(browser, path.join(IMAGES, name), server.url);
  console.log(`docs/images/${name}`);
}
await browser.close();
server.close();
