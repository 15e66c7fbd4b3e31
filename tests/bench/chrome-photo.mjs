// What an edit in a photo of 12 megapixels costs on the page in headless Chrome: a slider's tick on the page's own thread,
// all in, with the photo on the stage; and the photo's file at full size, from the press to the download.
import { readFile } from "node:fs/promises";
import { launch } from "../journeys/browser.mjs";
import { asJpeg } from "../journeys/pictures.mjs";
import { DIST, serve } from "../journeys/server.mjs";
import { scriptTime, traced } from "../journeys/trace.mjs";
import { SAMPLE, Visitor } from "../journeys/visitor.mjs";
import { report } from "./blank-page.mjs";

const LARGE = { width: 4000, height: 3000 };
const LOOKS = 9;
const TICKS = 40;
const FILES = 5;

const browser = await launch();
const server = await serve(DIST, "/");
try {
  const visitor = await Visitor.arrive(browser, server.url);
  const { page } = visitor;
  await visitor.untilLoaded();
  await visitor.drop(await asJpeg(page, await readFile(SAMPLE), LARGE), "large.jpg");
  await visitor.untilFace();
  await page.click("#photo-to-stage");
  for (const [density, vertices] of [["0", 468], ["3", 28_881]]) {
    await page.selectOption("#density", density, { force: true });
    await visitor.frames(20);
    const idle_ms = await spent(visitor, still);
    const times_ms = [];
    for (let look = 0; look < LOOKS; look += 1) times_ms.push(Math.max(0, (await spent(visitor, slide)) - idle_ms) / TICKS);
    report({ task: "photo-page-tick", peer: "rosto in Chrome", vertices }, times_ms);
  }
  await page.selectOption("#density", "0", { force: true });
  await visitor.slide("jaw-width", -6);
  for (const format of ["jpeg", "png"]) {
    await visitor.unfold("section-export");
    const times_ms = [];
    for (let file = 0; file < FILES; file += 1) {
      const start = performance.now();
      await Promise.all([page.waitForEvent("download"), page.click(`[data-action='download-photo-${format}']`)]);
      times_ms.push(performance.now() - start);
    }
    report({ task: `photo-file-${format}`, peer: "rosto in Chrome" }, times_ms);
  }
} finally {
  await browser.close();
  server.close();
}

/** Processor time in ms that the page's script spends on its thread while something is done. */
async function spent(visitor, act) {
  const events = await traced(visitor.page, () => visitor.page.evaluate(act, TICKS));
  return scriptTime(events);
}

/** Runs in the browser: as many frames as ticks, in which nothing happens. */
async function still(ticks) {
  for (let tick = 0; tick < ticks; tick += 1) await new Promise(requestAnimationFrame);
}

/** Runs in the browser: one tick of a ready-made slider for each frame. */
async function slide(ticks) {
  const range = document.querySelector("[data-slider='jaw-width'] input[type=range]");
  for (let tick = 0; tick < ticks; tick += 1) {
    range.value = String(-((tick % 20) + 1) / 4);
    range.dispatchEvent(new Event("input", { bubbles: true }));
    await new Promise(requestAnimationFrame);
  }
}
