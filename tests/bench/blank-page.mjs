// A page with nothing on it, in headless Chrome, for what is measured there; and the line that a measurement prints.
import path from "node:path";
import { launch } from "../journeys/browser.mjs";
import { serve } from "../journeys/server.mjs";

export const ROOT = path.resolve(import.meta.dirname, "../..");

/**
 * Runs `work` in an empty page beside the files of `folder`, with the sample portrait as `sample.png`.
 *
 * @template Argument, Result
 * @param {string} folder
 * @param {(argument: Argument) => Promise<Result>} work runs in the browser
 * @param {Argument} argument
 * @param {Record<string, string>} [beside] further folders, by the name under which the page sees their files
 * @returns {Promise<Result>}
 */
export async function inBlankPage(folder, work, argument, beside = {}) {
  const browser = await launch();
  const server = await serve(folder, "/");
  try {
    const page = await browser.newPage();
    const blank = { contentType: "text/html", body: "<!doctype html><title>bench</title>" };
    await page.route("**/blank.html", (route) => route.fulfill(blank));
    await page.route("**/sample.png", (route) => route.fulfill({ path: path.join(ROOT, "web/assets/sample.png") }));
    for (const [name, other] of Object.entries(beside)) {
      const file = (route) => path.join(other, path.basename(new URL(route.request().url()).pathname));
      await page.route(`**/${name}/*`, (route) => route.fulfill({ path: file(route) }));
    }
    await page.goto(`${server.url}blank.html`);
    return await page.evaluate(work, argument);
  } finally {
    await browser.close();
    server.close();
  }
}

/**
 * Prints the median as one JSON object on a line, as `peers.py` does.
 *
 * @param {{ task: string, peer: string, vertices?: number }} what
 * @param {number[]} figures
 * @param {"ms" | "px"} [unit]
 */
export function report(what, figures, unit = "ms") {
  const sorted = figures.toSorted((a, b) => a - b);
  console.log(JSON.stringify({ ...what, [unit]: sorted[sorted.length >> 1], runs: sorted.length }));
}
