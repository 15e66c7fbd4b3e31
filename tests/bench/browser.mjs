// Rosto in headless Chrome, compared with MediaPipe's page and onnxruntime-web: node tests/bench/browser.mjs [ROUNDS]
//
// Each measurement runs once in a fresh browser per round, the peers alternating and in turn first. Prints the medians of
// all rounds, a JSON object a line. Needs the built page in dist/ and the networks alone in target/bench/, which
// `cargo xtask bench browser` builds.
import path from "node:path";
import { launch } from "../e2e/browser.mjs";
import { serve } from "../e2e/server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
/** The exports of page.mjs. */
const MEASUREMENTS = ["photosByRosto", "photosByMediaPipe", "networks", "film", "editing"];

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
