// Benchmarks Rosto, MediaPipe's Face Mesh and onnxruntime-web in headless Chrome: node tests/bench/browser.mjs [ROUNDS]
//
// Runs each measurement once per round in a fresh browser, and reverses the order from round to round. Prints the
// medians of all rounds, one JSON object per line. Needs the built page in dist/, the npm package in target/npm/ and
// the networks module in target/bench/; `cargo xtask bench browser` builds them.
import path from "node:path";
import { launch } from "../e2e/browser.mjs";
import { serve } from "../e2e/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
/** Exports of page.mjs. */
const MEASUREMENTS = ["photosByRosto", "photosByMediaPipe", "networks", "video", "editing"];

const rounds = Number(process.argv[2] ?? 10);
/** @type {Map<string, number[]>} */
const values = new Map();
const server = await serve(ROOT, "/");
for (let round = 0; round < rounds; round += 1) {
  for (const measurement of round % 2 === 0 ? MEASUREMENTS : MEASUREMENTS.toReversed()) {
    for (const { value, ...what } of await inFreshBrowser(measurement)) {
      const key = JSON.stringify(what);
      values.set(key, [...(values.get(key) ?? []), value]);
    }
  }
}
server.close();
for (const [what, measured] of values) {
  console.log(JSON.stringify({ ...JSON.parse(what), value: median(measured), samples: measured.length }));
}

/** @param {string} measurement */
async function inFreshBrowser(measurement) {
  const browser = await launch();
  try {
    const page = await browser.newPage();
    await page.route("**/blank.html", (route) => route.fulfill({ contentType: "text/html", body: "<!doctype html><title>bench</title>" }));
    await page.goto(`${server.url}dist/${measurement === "editing" ? "index" : "blank"}.html`);
    return await page.evaluate(async (name) => (await import("/tests/bench/page.mjs"))[name](), measurement);
  } finally {
    await browser.close();
  }
}

/** @param {number[]} numbers */
function median(numbers) {
  const sorted = numbers.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}
