// The readers that run in a browser: three.js and <model-viewer>.
import path from "node:path";
import { PNG } from "pngjs";
import { launch } from "../journeys/browser.mjs";
import { colourCount } from "../journeys/pixels.mjs";
import { serve } from "../journeys/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
/** <model-viewer>'s warning where the machine draws fewer than two pictures a second: nothing about the file. */
const SLOW = "rAF timed out in updateSource";

/** @typedef {import("./judge.mjs").Seen} Seen */
/** @typedef {Awaited<ReturnType<typeof openPage>>} Open */

/** A page that both readers load into, with its warnings and errors. */
export async function openPage() {
  const browser = await launch({ gpu: "webgl" });
  const server = await serve(ROOT, "/");
  const page = await browser.newPage({ viewport: { width: 512, height: 512 } });
  /** @type {string[]} */
  const said = [];
  page.on("console", (message) => ["warning", "error"].includes(message.type()) && message.text() !== SLOW && said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  await page.goto(`${server.url}tests/readers/chromium/page.html`);
  return {
    page,
    /** Those since the last call. */
    remarks: () => said.splice(0),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}

/** A file's address for the page. @param {string} file */
export function urlOf(file) {
  return `/${path.relative(ROOT, file)}`;
}

/** @param {string[]} files */
export function readByThree(files) {
  return each(files, async ({ page }, url) => {
    // As text: passing numbers one by one takes longer than reading them.
    const seen = await page.evaluate(async (/** @type {string} */ at) => {
      const three = await import("/tests/readers/chromium/three-reads.mjs");
      return JSON.stringify(await three.see(at));
    }, url);
    return JSON.parse(seen);
  });
}

/** @param {string[]} files */
export function showInModelViewer(files) {
  return each(files, async ({ page }, url) => {
    const size = await page.evaluate(async (/** @type {string} */ at) => {
      const viewer = await import("/tests/readers/chromium/model-viewer-shows.mjs");
      return viewer.show(at);
    }, url);
    return { size, colours: colourCount(PNG.sync.read(await page.screenshot())) };
  });
}

/** @param {string[]} files @param {(open: Open, url: string) => Promise<Partial<Seen>>} see @returns {Promise<Seen[]>} */
async function each(files, see) {
  const open = await openPage();
  const all = [];
  for (const file of files) {
    const seen = await see(open, urlOf(file)).catch((error) => ({ error: String(error?.stack ?? error) }));
    all.push({ path: file, ...seen, remarks: open.remarks() });
  }
  await open.close();
  return all;
}
