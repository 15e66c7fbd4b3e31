// Readers in a browser: three.js and <model-viewer>.
import path from "node:path";
import { PNG } from "pngjs";
import { launch } from "../e2e/browser.mjs";
import { colourCount } from "../e2e/pixels.mjs";
import { serve } from "../e2e/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
/** <model-viewer>'s warning below two frames per second, which is unrelated to the file. */
const SLOW = "rAF timed out in updateSource";

/** @typedef {import("node:test").TestContext} TestContext */

/** Opens a page that imports a module, and collects its warnings and errors, until the test ends. @param {TestContext} t @param {string} url */
export async function openPage(t, url = "/tests/readers/chromium/three.mjs") {
  const browser = await launch({ gpu: "webgl" });
  t.after(() => browser.close());
  const server = await serve(ROOT, "/");
  t.after(() => server.close());
  const page = await browser.newPage({ viewport: { width: 512, height: 512 } });
  /** @type {string[]} */
  const remarks = [];
  page.on("console", (message) => {
    if (["warning", "error"].includes(message.type()) && message.text() !== SLOW) remarks.push(message.text());
  });
  page.on("pageerror", (error) => remarks.push(String(error)));
  await page.goto(`${server.url}tests/readers/chromium/page.html`);
  return { page, module: await page.evaluateHandle((address) => import(address), url), remarks };
}

/** URL of a file on the page. @param {string} file */
export function urlOf(file) {
  return `/${path.relative(ROOT, file)}`;
}

/** @param {TestContext} t */
export async function three(t) {
  const { module, remarks } = await openPage(t);
  return async (/** @type {string} */ file) => {
    // As text, because Playwright serialises large arrays of numbers slowly.
    const report = await module.evaluate(async ({ read }, url) => JSON.stringify(await read(url)), urlOf(file));
    return { ...JSON.parse(report), remarks: remarks.splice(0) };
  };
}

/** @param {TestContext} t */
export async function modelViewer(t) {
  const { page, remarks } = await openPage(t, "/node_modules/@google/model-viewer/dist/model-viewer.min.js");
  return async (/** @type {string} */ file) => {
    const size = await page.evaluate(async (src) => {
      const viewer = Object.assign(document.createElement("model-viewer"), { src, loading: "eager", interactionPrompt: "none" });
      document.body.replaceChildren(viewer);
      await new Promise((resolve, reject) => {
        viewer.addEventListener("load", resolve);
        viewer.addEventListener("error", ({ detail }) => reject(new Error(JSON.stringify(detail))));
      });
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      const { x, y, z } = viewer.getDimensions();
      return [x, y, z];
    }, urlOf(file));
    return { size, colours: colourCount(PNG.sync.read(await page.screenshot())), remarks: remarks.splice(0) };
  };
}
