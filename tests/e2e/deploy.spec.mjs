import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { appendFile, cp, readFile, readdir } from "node:fs/promises";
import path from "node:path";
import { promisify } from "node:util";
import { expect } from "@playwright/test";
import { variants, test as base } from "./fixtures.mjs";
import { DIST } from "./server.mjs";

const LISTING = path.resolve(import.meta.dirname, "../../web/list-for-offline.mjs");

/** Scripts that a tab loads later. */
const LATE = ["js/page/tasks.js", "js/worker/frames.js", "js/worker/validator-worker.js"];

/** Files that only browsers without WebGPU store. */
const FALLBACK = /^wasm\/rosto-studio-webgl/;

/** Tests with two builds of the page. */
const test = base.extend({
  // biome-ignore lint/correctness/noEmptyPattern: Playwright reads the dependencies here
  builds: async ({}, use, testInfo) => use(await Promise.all([1, 2].map((number) => buildOf(number, testInfo.outputPath(String(number)))))),
});

for (const [[when, needs], tag] of variants([["opened on the first visit", "gpu"], ["opened without WebGPU", "webgl"]])) {
  test(`after a deploy, a tab ${when} keeps its version, and a new tab has the new one`, { tag: [...tag, `@${needs}`] }, async ({ open, server, builds: [older, newer] }) => {
    server.deploy(older);
    const old = await open({ serviceWorkers: "allow" });
    await old.untilLoaded();
    if (needs === "webgl") {
      await old.page.reload();
      await old.untilLoaded();
      await old.page.waitForFunction(async () => Boolean(await caches.match("wasm/rosto-studio-webgl_bg.wasm")));
    }

    server.deploy(newer);
    await expectBuild(old, older, needs);
    const next = await old.openTab();
    await expectBuild(next, newer, needs);
    await next.page.reload();
    await next.untilLoaded();
    await expectBuild(next, newer, needs);
    await untilStored(next, 2);

    // The browser stops an idle service worker.
    for (const visitor of [old, next, old]) {
      await stopServiceWorkers(visitor.page);
      await expectBuild(visitor, visitor === old ? older : newer, needs);
    }
    await expectScripts(old, 1);
    await expectScripts(next, 2);
    await old.page.bringToFront();
    await old.dropSample();
    server.intercept((_, response) => Boolean(response.writeHead(503).end()));
    await next.page.bringToFront();
    await next.page.reload();
    await next.page.waitForSelector("body[data-host='open']");
    await expectBuild(next, newer, needs);
    server.intercept();

    // On a page outside its scope, the new service worker activates once the old one has stopped.
    await old.page.close();
    const nowhere = new URL("/", server.url).href;
    await next.page.route(nowhere, (route) => route.fulfill({ contentType: "text/html", body: "" }));
    await next.page.goto(nowhere);
    await stopServiceWorkers(next.page);
    await next.page.goto(server.url);
    await next.untilLoaded();
    await untilStored(next, 1);
    await expectBuild(next, newer);
    server.intercept((_, response) => Boolean(response.writeHead(503).end()));
    await next.page.reload();
    await next.page.waitForSelector("body[data-host='open']");
    await expectBuild(next, newer, needs);
  });
}

test("a version that was not stored gets no files of the next one", async ({ open, server, builds: [older, newer] }) => {
  server.deploy(older);
  const old = await open({ serviceWorkers: "allow" });
  await old.untilLoaded();
  server.deploy(newer);
  server.intercept((name, response) => name === "service-worker.js" && Boolean(response.writeHead(503).end()));
  const next = await old.openTab();
  await expectBuild(next, newer);
  // Simulates a third version.
  server.deploy(older);
  const files = ["words/pt.json", "js/page/tasks.js", "css/base.css"];
  assert.deepEqual(await textsIn(next.page, files), files.map(() => "refused"));
  await expectBuild(old, older);
});

/**
 * Copies the build, appends a comment to each file that allows one, and makes late scripts set `build` to its number.
 */
async function buildOf(number, folder) {
  await cp(DIST, folder, { recursive: true });
  const files = (await readdir(folder, { recursive: true })).filter((name) => /^(js|css|words|wasm)\/.*\.(js|css|json)$/.test(name));
  const text = (file) => (file.endsWith("json") ? " ".repeat(number) : `/* ${number} */`);
  for (const file of files) await appendFile(path.join(folder, file), `\n${text(file)}\n`);
  for (const file of LATE) await appendFile(path.join(folder, file), `globalThis.build = ${number};\n`);
  await promisify(execFile)(process.execPath, [LISTING], { env: { ...process.env, TRUNK_STAGING_DIR: folder } });
  return folder;
}

/** Expects a tab to get the files of a build; files that this browser does not store may be refused. */
async function expectBuild({ page }, folder, needs = "gpu") {
  const { files } = JSON.parse(String(await readFile(path.join(folder, "integrity.json"))));
  const names = Object.keys(files).filter((name) => /\.(js|css|json)$/.test(name));
  const texts = await textsIn(page, names);
  for (const [place, file] of names.entries()) {
    const isMissing = needs !== "webgl" && FALLBACK.test(file) && texts[place] === "refused";
    assert.ok(isMissing || texts[place] === (await readFile(path.join(folder, file), "utf8")), `${file} is of another build`);
  }
}

/** Text of each file as the tab fetches it. @param {import("@playwright/test").Page} page @param {string[]} files */
function textsIn(page, files) {
  const fetchAll = (files) => Promise.all(files.map((file) => fetch(file).then((answer) => answer.text(), () => "refused")));
  return page.evaluate(fetchAll, files);
}

/** Expects late scripts of a build: a module, a restarted worker and another worker. */
async function expectScripts({ page }, build) {
  await page.evaluate(() => {
    delete globalThis.build;
    return import("./js/page/tasks.js?late");
  });
  const dying = page.workers().find((worker) => worker.url().endsWith("vision-worker.js"));
  const [worker] = await Promise.all([page.waitForEvent("worker"), dying.evaluate(() => self.close()).catch(() => {})]);
  const start = async () => new (await import("./js/page/validator.js")).Validator().start();
  const [validator] = await Promise.all([page.waitForEvent("worker"), page.evaluate(start)]);
  for (const place of [page, worker, validator]) await expect.poll(() => place.evaluate(() => globalThis.build)).toBe(build);
}

/**
 * Waits until `count` versions are stored completely, including the page: stopping the service worker earlier aborts
 * its installation.
 */
async function untilStored({ page }, count) {
  const stores = () => page.evaluate(async () => {
    const pages = (await caches.keys()).map((cacheName) => caches.match("./", { cacheName }));
    return (await Promise.all(pages)).filter(Boolean).length;
  });
  await expect.poll(stores).toBe(count);
}

/** @param {import("@playwright/test").Page} page */
async function stopServiceWorkers(page) {
  const browser = await page.context().newCDPSession(page);
  await browser.send("ServiceWorker.enable");
  await browser.send("ServiceWorker.stopAllWorkers");
  await browser.detach();
}
