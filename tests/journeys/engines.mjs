// The core journey and the element's in every engine, through WebGL2: node tests/journeys/engines.mjs [ENGINE…]. Screenshots go to
// target/engines.
import path from "node:path";
import { chromium } from "./engines/chromium.mjs";
import { core } from "./engines/core.mjs";
import { openDisplay } from "./engines/display.mjs";
import { element } from "./engines/element.mjs";
import { firefox } from "./engines/firefox.mjs";
import { BrowserCrashed } from "./engines/hand.mjs";
import { webkit } from "./engines/webkit.mjs";
import { installed, SITE } from "./package.mjs";
import { DIST, serve } from "./server.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const PICTURES = path.join(ROOT, "target/engines");
/** Launches per engine. WebKitGTK 2.50 sometimes crashes in its WebAssembly interpreter; a second crash fails the test. */
const MOST_LAUNCHES = 2;

const ENGINES = { chromium, firefox: onDisplay(firefox), webkit: onDisplay(webkit) };

const wanted = process.argv.slice(2);
await installed();
const [server, site] = await Promise.all([serve(DIST, "/some/where/"), serve(SITE, "/a/page/")]);
const rows = [];
for (const [name, launch] of Object.entries(ENGINES)) {
  if (wanted.length === 0 || wanted.includes(name)) rows.push(await visit(name, launch));
}
for (const one of [server, site]) one.close();
const passed = rows.filter((row) => row.passed === "yes").length;
console.log(`\n${table(rows)}\n\nengines: ${passed} passed, ${rows.length - passed} failed`);
process.exitCode = passed === rows.length && passed > 0 ? 0 : 1;

/** @param {string} name @param {() => Promise<import("./engines/hand.mjs").Driver>} launch @param {number} [launchesLeft] */
async function visit(name, launch, launchesLeft = MOST_LAUNCHES) {
  const started = performance.now();
  const row = { engine: name, version: "—", "drawn by": "—", passed: "no", seconds: "" };
  /** @type {import("./engines/hand.mjs").Driver | undefined} */
  let driver;
  let willRetry = false;
  try {
    driver = await launch();
    row.engine = driver.engine;
    row.version = driver.version;
    row["drawn by"] = await core(driver, server.url, PICTURES);
    await element(driver, site.url, PICTURES);
    row.passed = "yes";
  } catch (error) {
    willRetry = error instanceof BrowserCrashed && launchesLeft > 1;
    console.log(willRetry ? `${row.engine} ${row.version} crashed; launching it again` : `✗ ${row.engine} ${row.version}: ${error?.stack ?? error}`);
    const errors = await driver?.errors().catch(() => []);
    for (const error of errors ?? []) console.log(`    page: ${error}`);
  } finally {
    await driver?.close().catch((error) => console.log(`  ${row.engine} did not close: ${error.message}`));
  }
  if (willRetry) return visit(name, launch, launchesLeft - 1);
  row.seconds = ((performance.now() - started) / 1000).toFixed(1);
  return row;
}

/**
 * An engine on a screen of its own, which goes with it.
 *
 * @param {(env: NodeJS.ProcessEnv) => Promise<import("./engines/hand.mjs").Driver>} launch
 */
function onDisplay(launch) {
  return async () => {
    const display = await openDisplay();
    try {
      const driver = await launch(display.env);
      return { ...driver, close: () => driver.close().finally(display.close) };
    } catch (error) {
      display.close();
      throw error;
    }
  };
}

/** @param {Record<string, string>[]} rows */
function table(rows) {
  const columns = Object.keys(rows[0] ?? { engine: "" });
  const width = (/** @type {string} */ column) => Math.max(...[column, ...rows.map((row) => row[column])].map(({ length }) => length));
  const line = (/** @type {(column: string) => string} */ cell) => `| ${columns.map((column) => cell(column).padEnd(width(column))).join(" | ")} |`;
  return [line((column) => column), line((column) => "-".repeat(width(column))), ...rows.map((row) => line((column) => row[column]))].join("\n");
}
