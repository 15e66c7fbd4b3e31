// Walks every journey through the built page, or those whose names contain the words given, and counts. With --timed, the
// ones that measure instead: what they find depends on what else the machine does.
import { mkdtemp, readFile, readdir, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { launch } from "./browser.mjs";
import { journeys } from "./journey.mjs";
import { asFilm } from "./pictures.mjs";
import { DIST, serve } from "./server.mjs";
import { SAMPLE, Visitor } from "./visitor.mjs";

const HERE = import.meta.dirname;
const BELOW = "/some/where/";
const LIMIT_MS = 180_000;

const ending = process.argv.includes("--timed") ? ".timed.mjs" : ".journey.mjs";
for (const file of (await readdir(HERE)).filter((name) => name.endsWith(ending)).sort()) {
  await import(path.join(HERE, file));
}

const wanted = process.argv.slice(2).filter((word) => word !== "--timed").join(" ");
const chosen = journeys.filter(({ name }) => name.includes(wanted));
const server = await serve(DIST, BELOW);
/** @type {Map<string, import("playwright-core").Browser>} */
const browsers = new Map();
let passed = 0;
let failed = 0;

for (const one of chosen) {
  const started = performance.now();
  const visitors = [];
  try {
    await within(LIMIT_MS, one.walk(async ({ url = server.url, ...options } = {}) => {
      const visitor = await Visitor.arrive(await browserFor(one.needs), url, options);
      visitors.push(visitor);
      return visitor;
    }));
    for (const visitor of visitors) visitor.checkNothingBroke();
    passed += 1;
    console.log(`✓ ${one.name} (${seconds(started)})`);
  } catch (error) {
    failed += 1;
    console.log(`✗ ${one.name} (${seconds(started)})\n${indent(error?.stack ?? String(error))}`);
    for (const visitor of visitors) for (const line of visitor.said) console.log(indent(`page: ${line}`));
  } finally {
    for (const visitor of visitors) await visitor.leave();
  }
}

for (const browser of browsers.values()) await browser.close();
server.close();
console.log(`journeys: ${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 && passed > 0 ? 0 : 1;

/** @param {import("./journey.mjs").Journey["needs"]} needs */
async function browserFor(needs) {
  const open = browsers.get(needs) ?? (await launchFor(needs));
  browsers.set(needs, open);
  return open;
}

/** @param {import("./journey.mjs").Journey["needs"]} needs */
async function launchFor(needs) {
  if (needs === "no-gpu") return launch({ gpu: "none" });
  if (needs === "webgl") return launch({ gpu: "webgl" });
  if (needs !== "camera") return launch();
  const film = path.join(await mkdtemp(path.join(tmpdir(), "rosto-")), "portrait.y4m");
  await writeFile(film, asFilm(await readFile(SAMPLE), 5));
  return launch({ film });
}

/**
 * @param {number} limit_ms
 * @param {Promise<void>} work
 */
async function within(limit_ms, work) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`not done after ${limit_ms / 1000} s`)), limit_ms);
  });
  await Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** @param {number} started */
function seconds(started) {
  return `${((performance.now() - started) / 1000).toFixed(1)} s`;
}

/** @param {string} text */
function indent(text) {
  return text.replaceAll(/^/gm, "    ");
}
