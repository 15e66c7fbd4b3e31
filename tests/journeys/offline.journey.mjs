import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { alike, test } from "./fixtures.mjs";
import { DIST } from "./server.mjs";

/** @type {Record<string, import("./server.mjs").Disturbance>} */
const TROUBLES = {
  "answers 503 to everything": (_, response) => fail(response, 503),
  "has lost its files": (_, response) => fail(response, 404),
  "accepts and is silent": () => true,
  "gives the page, then 503": (name, response) => name !== "" && fail(response, 503),
  "gives the page, then is silent": (name) => name !== "",
  "begins the page and is silent": (name, response) => name === "" && begin(response),
  "gives a page of its own for every file": (name, response) => name !== "" && portal(response),
};

for (const [[what, disturbance], tag] of alike(Object.entries(TROUBLES))) {
  test(`the stored page works with a server that ${what}`, { tag }, async ({ open, server }) => {
    const visitor = await open({ serviceWorkers: "allow" });
    await visitor.untilLoaded();
    server.disturb(disturbance);
    await visitor.page.reload();
    // The browser looks for a newer service worker by itself, at a time of its own, and the page's wish has to wait.
    await visitor.page.evaluate(() => void navigator.serviceWorker.ready.then((kept) => kept.update()).catch(() => {}));
    await visitor.page.click("#welcome [data-action='sample']");
    await visitor.untilFace();
    await visitor.untilLoaded();
    assert.ok(await visitor.page.isHidden("#not-started"));
  });
}

test("a page of a newer version comes from the network with all its files, or says that it did not load", async ({ open, server }) => {
  const visitor = await open({ serviceWorkers: "allow" });
  await visitor.untilLoaded();
  const newer = String(await readFile(path.join(DIST, "index.html"))).replace(/(name="version" content=")\w+/, "$1newer");

  /** @type {string[]} */
  const asked = [];
  server.disturb((name, response) => {
    asked.push(name);
    return name === "" && send(response, newer);
  });
  await visitor.page.reload();
  await visitor.untilLoaded();
  for (const file of ["css/base.css", "js/main.js", "words/en.json", "wasm/rosto-vision-web_bg.wasm", "assets/sample.png"]) {
    assert.ok(asked.includes(file), `${file} came from the store of an older version`);
  }
  // The browser ends a service worker that has had nothing to do for a while.
  await stopServiceWorkers(visitor.page);
  asked.length = 0;
  await visitor.page.evaluate(() => fetch("js/main.js"));
  assert.deepEqual(asked, ["js/main.js"]);

  server.disturb((name, response) => (name === "" ? send(response, newer) : name === "words/en.json" && fail(response, 503)));
  await visitor.page.reload();
  await visitor.page.waitForSelector("#not-started");
  assert.equal(visitor.broken.splice(0).length, 1, "the page reports what did not load");

  // The older version is still whole.
  server.disturb(() => true);
  await visitor.page.click("#start-again");
  await visitor.page.waitForSelector("body[data-bench='open']");
  assert.ok(await visitor.page.isHidden("#not-started"));
});

test("what is not the file that was built is not stored", async ({ open, server }) => {
  const tabs = await readFile(path.join(DIST, "js/page/tabs.js"));
  server.disturb((name, response) => name === "js/page/tabs.js" && send(response, `${tabs}\n// from another version\n`, "text/javascript"));
  const visitor = await open({ serviceWorkers: "allow" });
  await visitor.untilLoaded();
  assert.equal(await isKept(visitor), false);

  server.disturb();
  await visitor.page.reload();
  await visitor.untilLoaded();
  assert.equal(await isKept(visitor), true);
  server.disturb(() => true);
  await visitor.page.reload();
  await visitor.page.waitForSelector("body[data-bench='open']");
});

/** @param {import("@playwright/test").Page} page */
async function stopServiceWorkers(page) {
  const browser = await page.context().newCDPSession(page);
  await browser.send("ServiceWorker.enable");
  await browser.send("ServiceWorker.stopAllWorkers");
  await browser.detach();
}

/** @param {import("./visitor.mjs").Visitor} visitor */
function isKept(visitor) {
  return visitor.page.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration())?.active));
}

/** @param {import("node:http").ServerResponse} response @param {number} status */
function fail(response, status) {
  response.writeHead(status, { "content-type": "text/html" }).end("<!doctype html><title>No</title><p>Not now.");
  return true;
}

/** @param {import("node:http").ServerResponse} response */
function portal(response) {
  return send(response, "<!doctype html><title>Welcome aboard</title><p>Please log in.");
}

/** @param {import("node:http").ServerResponse} response */
function begin(response) {
  response.writeHead(200, { "content-type": "text/html" }).write("<!doctype html><html><head>");
  return true;
}

/** @param {import("node:http").ServerResponse} response @param {string} text @param {string} [type] */
function send(response, text, type = "text/html; charset=utf-8") {
  response.writeHead(200, { "content-type": type, "cache-control": "no-cache" }).end(text);
  return true;
}
