// The readers that run in a browser: three.js and <model-viewer>.
import { readFileSync } from "node:fs";
import path from "node:path";
import { PNG } from "pngjs";
import { launch } from "../journeys/browser.mjs";
import { colourCount } from "../journeys/pixels.mjs";
import { serve } from "../journeys/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
/** What <model-viewer> says where the machine draws fewer than two pictures a second: nothing about the file. */
const SLOW = "rAF timed out in updateSource";
const BLANK = "tests/readers/chromium/page.html";

/** @typedef {import("./readers.mjs").Seen} Seen */

/** A page that both readers can be loaded into, with what it says on its console. */
export async function openPage() {
  const browser = await launch({ gpu: "webgl" });
  const server = await serve(ROOT, "/");
  const page = await browser.newPage({ viewport: { width: 512, height: 512 } });
  /** @type {string[]} */
  const said = [];
  const isRemark = (message) => ["warning", "error"].includes(message.type()) && message.text() !== SLOW;
  page.on("console", (message) => isRemark(message) && said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  await page.goto(`${server.url}${BLANK}`);
  return {
    page,
    /** What has been said since it was asked last: warnings and errors. */
    remarks: () => said.splice(0),
    close: async () => {
      await browser.close();
      server.close();
    },
  };
}

/** The files as three.js' loaders have them. @param {string[]} files @returns {Promise<Seen[]>} */
export function readByThree(files) {
  return each(files, async ({ page, remarks }, url) => {
    // As text: number by number, it would take longer to pass on than to read.
    const seen = await page.evaluate(async (/** @type {string} */ at) => {
      const three = await import("/tests/readers/chromium/three-reads.mjs");
      return JSON.stringify({ version: three.version, ...(await three.see(at)) });
    }, url);
    return { reader: "three.js", ...JSON.parse(seen), remarks: remarks() };
  });
}

/** The files as <model-viewer> shows them. @param {string[]} files @returns {Promise<Seen[]>} */
export function showInModelViewer(files) {
  const version = versionOf("@google/model-viewer");
  return each(files, async ({ page, remarks }, url) => {
    const seen = await page.evaluate(async (/** @type {string} */ at) => {
      const viewer = await import("/tests/readers/chromium/model-viewer-shows.mjs");
      return viewer.show(at);
    }, url);
    const colours = colourCount(PNG.sync.read(await page.screenshot()));
    return { reader: "model-viewer", version, ...seen, colours, remarks: remarks() };
  });
}

/** The version of a package as it is installed. @param {string} name */
export function versionOf(name) {
  return JSON.parse(readFileSync(path.join(ROOT, "node_modules", name, "package.json"), "utf8")).version;
}

/** The path under which a page asks for a file. @param {string} file */
export function urlOf(file) {
  return `/${path.relative(ROOT, file)}`;
}

/**
 * @param {string[]} files
 * @param {(open: Awaited<ReturnType<typeof openPage>>, url: string) => Promise<object>} see
 */
async function each(files, see) {
  const open = await openPage();
  const all = [];
  for (const file of files) {
    const seen = await see(open, urlOf(file)).catch((error) => ({ error: String(error?.stack ?? error), remarks: open.remarks() }));
    all.push({ path: file, ...seen });
  }
  await open.close();
  return all;
}
