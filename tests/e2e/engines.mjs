// Runs the core scenario and the element's in each browser engine, with WebGL2: node tests/e2e/engines.mjs [ENGINE…]
// Screenshots go to target/engines.
import { mkdir } from "node:fs/promises";
import path from "node:path";
import { ENGINES, openDisplay, start } from "./engines/browsers.mjs";
import { runCoreScenario, runElementScenario } from "./engines/scenarios.mjs";
import { installed, SITE } from "./package.mjs";
import { DIST, serve } from "./server.mjs";

const PICTURES = path.resolve(import.meta.dirname, "../../target/engines");
/**
 * Launches per engine. WebKitGTK 2.50 sometimes crashes in its WebAssembly interpreter; a second crash fails the test.
 */
const MAX_LAUNCHES = 2;

const wanted = process.argv.slice(2);
const names = Object.keys(ENGINES).filter((name) => wanted.length === 0 || wanted.includes(name));
await installed();
await mkdir(PICTURES, { recursive: true });
const [core, element] = await Promise.all([serve(DIST, "/some/where/"), serve(SITE, "/a/page/")]);
const display = await openDisplay();
let passed = 0;
for (const name of names) if (await visit(name)) passed += 1;
for (const one of [core, element, display]) one.close();
console.log(`engines: ${passed} passed, ${names.length - passed} failed`);
process.exitCode = passed > 0 && passed === names.length ? 0 : 1;

/** @param {keyof typeof ENGINES} name @returns {Promise<boolean>} whether it passed */
async function visit(name) {
  for (let launch = 1; ; launch++) {
    const started = performance.now();
    /** @type {import("./engines/browsers.mjs").Browser | undefined} */
    let browser;
    try {
      browser = await start(name, display.env);
      const drawnBy = await runCoreScenario(browser, core.url, PICTURES);
      await runElementScenario(browser, element.url, PICTURES);
      console.log(`✓ ${browser.version}, drawn by ${drawnBy} (${((performance.now() - started) / 1000).toFixed(0)} s)`);
      return true;
    } catch (error) {
      const willRetry = browser?.crashed(error) && launch < MAX_LAUNCHES;
      console.log(willRetry ? `${name} crashed; launching it again` : `✗ ${name}: ${error.stack}`);
      if (willRetry) continue;
      for (const line of (await browser?.errors().catch(() => [])) ?? []) console.log(`    page: ${line}`);
      return false;
    } finally {
      await browser?.close();
    }
  }
}
