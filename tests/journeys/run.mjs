// Walks the journeys of a test run through the built page, with --all every one, or those whose names contain the words
// given, and counts. Two are walked at a time, each in a browser of its own, where the machine has two cores. With --timed,
// the ones that measure instead, one by one: what they find depends on what else the machine does.
import { readdir } from "node:fs/promises";
import { availableParallelism } from "node:os";
import path from "node:path";
import { Browsers } from "./browsers.mjs";
import { WANTED, journeys } from "./journey.mjs";
import { DIST, serve } from "./server.mjs";
import { Visitor } from "./visitor.mjs";

const HERE = import.meta.dirname;
const BELOW = "/some/where/";
const LIMIT_MS = 180_000;

const isTimed = process.argv.includes("--timed");
const LANES = isTimed ? 1 : Math.min(2, availableParallelism());

const ending = isTimed ? ".timed.mjs" : ".journey.mjs";
for (const file of (await readdir(HERE)).filter((name) => name.endsWith(ending)).sort()) {
  await import(path.join(HERE, file));
}

const waiting = journeys.filter(({ name }) => name.includes(WANTED));
const server = await serve(DIST, BELOW);
let passed = 0;
let failed = 0;

await Promise.all(Array.from({ length: LANES }, walkInLane));
server.close();
console.log(`journeys: ${passed} passed, ${failed} failed`);
// What a journey that was not done in time still waits for holds nothing up.
process.exit(failed === 0 && passed > 0 ? 0 : 1);

/** One journey after the other, as long as any is waiting. */
async function walkInLane() {
  const browsers = new Browsers({ isTimed });
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
      visitor.sees = browsers.sees(needs);
      visitors.push(visitor);
      return visitor;
    }));
    for (const visitor of visitors) visitor.checkNothingBroke();
    passed += 1;
    console.log(`✓ ${name} (${seconds(started)})`);
  } catch (error) {
    failed += 1;
    console.log(`✗ ${name} (${seconds(started)})\n${indent(error?.stack ?? String(error))}`);
    for (const { said, browserSaid } of visitors) {
      for (const line of said) console.log(indent(`page: ${line}`));
      for (const line of browserSaid) console.log(indent(`browser: ${line}`));
    }
  } finally {
    for (const visitor of visitors) {
      if (!(await browsers.leave(visitor))) console.log(`  the browser did not let go of its page, and was ended: ${name}`);
    }
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
