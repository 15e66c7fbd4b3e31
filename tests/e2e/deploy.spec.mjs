import assert from "node:assert/strict";
import { appendFile, cp, readFile, readdir, rename, writeFile } from "node:fs/promises";
import path from "node:path";
import { expect } from "@playwright/test";
import { release, UNNAMED } from "../../web/build/release.mjs";
import { test as base } from "./fixtures.mjs";
import { DIST, versionIn } from "./server.mjs";

/** Workers, which a tab starts again or later. */
const WORKERS = ["vision-worker.js", "validator-worker.js"];

/** Files that only browsers without WebGPU store. */
const FALLBACK = /^rosto-studio-webgl/;

/** Tests with two builds of the page. */
const test = base.extend({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the dependencies here
  builds: async ({}, use, testInfo) => use(await Promise.all([1, 2].map((number) => buildOf(number, testInfo.outputPath(String(number)))))),
});

for (const [when, needs] of /** @type {const} */ ([["opened on the first visit", "gpu"], ["opened without WebGPU", "webgl"]])) {
  test(`after a deploy, a tab ${when} keeps its version, and a new tab has the new one`, { tag: `@${needs}` }, async ({ open, server, builds: [older, newer] }) => {
    await server.deploy(older);
    const old = await open({ serviceWorkers: "allow" });
    await old.untilLoaded();

    // The host keeps no file of the earlier version.
    await server.deploy(newer);
    const next = await old.openTab();
    await expectBuild(next, newer, needs);
    await next.page.reload();
    await next.untilLoaded();
    for (const visitor of [old, next]) await expectBuild(visitor, visitor === old ? older : newer, needs);

    await untilStored(next, newer);

    // The browser stops an idle service worker.
    await stopServiceWorkers(old.page);
    await expectBuild(old, older, needs);
    await old.page.bringToFront();
    const dying = old.page.workers().find((worker) => worker.url().endsWith("vision-worker.js"));
    const [worker] = await Promise.all([old.page.waitForEvent("worker"), dying.evaluate(() => self.close()).catch(() => {})]);
    await expect.poll(() => worker.evaluate(() => globalThis.build)).toBe(1);
    const validator = old.page.workers().find((worker) => worker.url().endsWith("validator-worker.js"));
    assert.equal(await validator.evaluate(() => globalThis.build), 1);
    await old.setLanguage("pt");
    await old.setLanguage("en");
    await old.dropSample();

    // Without a server, both versions work; a reload gives the newest.
    server.intercept((_, response) => Boolean(response.writeHead(503).end()));
    await expectBuild(old, older, needs);
    await old.page.reload();
    await old.page.waitForSelector("body[data-host='open']");
    await expectBuild(old, newer, needs);
    await next.page.bringToFront();
    await next.page.reload();
    await next.page.waitForSelector("body[data-host='open']");
    await expect.poll(() => next.page.evaluate("caches.keys().then(({ length }) => length)"), "no tab uses the earlier version").toBe(1);
  });
}

/**
 * Copies the build, appends a comment to each file that allows one, and makes workers set `build` to its number.
 */
async function buildOf(number, folder) {
  const version = await versionIn(DIST);
  await cp(DIST, folder, { recursive: true });
  await rename(path.join(folder, version), path.join(folder, UNNAMED));
  const page = path.join(folder, "index.html");
  await writeFile(page, String(await readFile(page)).replaceAll(`${version}/`, `${UNNAMED}/`));
  const files = (await readdir(path.join(folder, UNNAMED))).filter((name) => /\.(js|css)$/.test(name));
  for (const file of files) await appendFile(path.join(folder, UNNAMED, file), `\n/* ${number} */\n`);
  for (const file of WORKERS) await appendFile(path.join(folder, UNNAMED, file), `globalThis.build = ${number};\n`);
  await release(folder);
  return folder;
}

/** Expects a tab to run a build and to get its files; files that this browser does not store may be refused. */
async function expectBuild({ page }, folder, needs) {
  const version = await versionIn(folder);
  const script = await page.locator("script[type='module']").getAttribute("src");
  assert.equal(script, `${version}/page.js`);
  const names = (await readdir(path.join(folder, version))).filter((name) => /\.(js|css)$/.test(name));
  const fetchAll = (files) => Promise.all(files.map((file) => fetch(file).then((answer) => (answer.ok ? answer.text() : "refused"), () => "refused")));
  const texts = await page.evaluate(fetchAll, names.map((name) => `${version}/${name}`));
  for (const [place, name] of names.entries()) {
    const isMissing = needs !== "webgl" && FALLBACK.test(name) && texts[place] === "refused";
    assert.ok(isMissing || texts[place] === (await readFile(path.join(folder, version, name), "utf8")), `${name} is of another build`);
  }
}

/** Waits until the service worker has stored a version. @param {import("./visitor.mjs").Visitor} visitor @param {string} folder */
async function untilStored({ page }, folder) {
  const cacheName = `rosto-${await versionIn(folder)}`;
  await expect.poll(() => page.evaluate((cacheName) => caches.match("./", { cacheName }).then(Boolean), cacheName)).toBe(true);
}

/** @param {import("@playwright/test").Page} page */
async function stopServiceWorkers(page) {
  const browser = await page.context().newCDPSession(page);
  await browser.send("ServiceWorker.enable");
  await browser.send("ServiceWorker.stopAllWorkers");
  await browser.detach();
}
