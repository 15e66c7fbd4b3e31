// Walks every journey through the built page, or those whose names contain the words given, and counts. Two are walked at
// a time, each in a browser of its own, where the machine has two cores. With --timed, the ones that measure instead, one
// by one: what they find depends on what else the machine does.
import { readdir } from "node:fs/promises";
import { availableParallelism } from "node:os";
import path from "node:path";
import { launch } from "./browser.mjs";
import { movingFilm } from "./film.mjs";
import { journeys } from "./journey.mjs";
import { portraitFilm } from "./pictures.mjs";
import { DIST, serve } from "./server.mjs";
import { Visitor } from "./visitor.mjs";

const HERE = import.meta.dirname;
const BELOW = "/some/where/";
const LIMIT_MS = 180_000;

/** @typedef {import("./journey.mjs").Journey["needs"]} Needs */

/** Browsers whose screenshots do not show the 3D view. @type {Set<Needs>} */
const UNSEEN = new Set(["gpu", "camera", "moving-camera"]);

/** The browsers of one lane, each launched when it is first needed. */
class Browsers {
  /** @type {Map<Needs, import("playwright-core").Browser>} */
  #open = new Map();

  /** @param {Needs} needs */
  async for(needs) {
    const open = this.#open.get(needs) ?? (await launchFor(needs));
    this.#open.set(needs, open);
    return open;
  }

  async close() {
    for (const browser of this.#open.values()) await browser.close();
  }
}

/** What is timed is timed as visitors have it. @param {Needs} needs */
function sees(needs) {
  return isTimed || !UNSEEN.has(needs);
}

/** @param {Needs} needs */
async function launchFor(needs) {
  if (needs === "no-gpu") return launch({ gpu: "none" });
  if (needs === "webgl") return launch({ gpu: "webgl" });
  const seen = sees(needs);
  if (needs === "camera") return launch({ film: await portraitFilm(), seen });
  if (needs === "moving-camera" || needs === "seen-camera") return launch({ film: await movingFilm(), seen });
  return launch({ seen });
}

const isTimed = process.argv.includes("--timed");
const LANES = isTimed ? 1 : Math.min(2, availableParallelism());

const ending = isTimed ? ".timed.mjs" : ".journey.mjs";
for (const file of (await readdir(HERE)).filter((name) => name.endsWith(ending)).sort()) {
  await import(path.join(HERE, file));
}

const wanted = process.argv.slice(2).filter((word) => word !== "--timed").join(" ");
const waiting = journeys.filter(({ name }) => name.includes(wanted));
const server = await serve(DIST, BELOW);
let passed = 0;
let failed = 0;

await Promise.all(Array.from({ length: LANES }, walkInLane));
server.close();
console.log(`journeys: ${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 && passed > 0 ? 0 : 1;

/** One journey after the other, as long as any is waiting. */
async function walkInLane() {
  const browsers = new Browsers();
  for (let next = waiting.shift(); next; next = waiting.shift()) await walkOne(next, browsers);
  await browsers.close();
}

/** @param {import("./journey.mjs").Journey} journey @param {Browsers} browsers */
async function walkOne({ name, needs, walk }, browsers) {
  const started = performance.now();
  const visitors = [];
  try {
    await within(LIMIT_MS, walk(async ({ url = server.url, ...options } = {}) => {
      const visitor = await Visitor.arrive(await browsers.for(needs), url, options);
      visitor.sees = sees(needs);
      visitors.push(visitor);
      return visitor;
    }));
    for (const visitor of visitors) visitor.checkNothingBroke();
    passed += 1;
    console.log(`✓ ${name} (${seconds(started)})`);
  } catch (error) {
    failed += 1;
    console.log(`✗ ${name} (${seconds(started)})\n${indent(error?.stack ?? String(error))}`);
    for (const visitor of visitors) for (const line of visitor.said) console.log(indent(`page: ${line}`));
  } finally {
    for (const visitor of visitors) await visitor.leave();
  }
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
