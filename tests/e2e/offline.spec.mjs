import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { variants, test } from "./fixtures.mjs";
import { DIST } from "./server.mjs";

test.use({ visit: { serviceWorkers: "allow" } });

const NOT_NOW = "<!doctype html><title>No</title><p>Not now.";

/** @type {Record<string, import("./server.mjs").Interceptor>} */
const FAULTS = {
  "answers each request with 503": (_, response) => send(response, 503, NOT_NOW),
  "has lost its files": (_, response) => send(response, 404, NOT_NOW),
  "accepts connections and does not answer": () => true,
  "sends the page, then 503": (name, response) => name !== "" && send(response, 503, NOT_NOW),
  "sends the page, then does not answer": (name) => name !== "",
  "sends the start of the page and stops": (name, response) => name === "" && response.writeHead(200, { "content-type": "text/html" }).write("<!doctype html>"),
  "sends an HTML page for each file": (name, response) => name !== "" && send(response, 200, "<title>Welcome aboard</title>"),
};

for (const [[what, interceptor], tag] of [[["is unreachable"], []], ...variants(Object.entries(FAULTS))]) {
  test(`the stored page works with a server that ${what}`, { tag }, async ({ visitor, page, server }) => {
    await visitor.untilLoaded();
    server.intercept(interceptor);
    await page.context().setOffline(!interceptor);
    await page.reload();
    // The browser checks for a new service worker at any time; a reload must work meanwhile.
    await page.evaluate(() => void navigator.serviceWorker.ready.then((kept) => kept.update()).catch(() => {}));
    await page.click("#welcome [data-action='sample']");
    await visitor.untilFace();
    // The validator comes from the same cache, slightly later.
    await visitor.untilLoaded();
    assert.ok(await page.isHidden("#not-started"));
    await visitor.unfold("section-export");
    await page.click("[data-action='check-glb']");
    await page.waitForSelector("#verdict[data-verdict='valid']");
  });
}

test("a page of a newer version loads its files from the network, or reports that it did not load", async ({ visitor, page, server }) => {
  await visitor.untilLoaded();
  const newer = String(await readFile(path.join(DIST, "index.html"))).replace(/(name="version" content=")\w+/, "$1newer");

  /** @type {string[]} */
  const asked = [];
  server.intercept((name, response) => {
    asked.push(name);
    return name === "" && send(response, 200, newer);
  });
  await page.reload();
  await visitor.untilLoaded();
  for (const file of ["css/base.css", "js/main.js", "words/en.json", "wasm/rosto-vision-web_bg.wasm", "assets/sample.png"]) {
    assert.ok(asked.includes(file), `${file} came from the store of an older version`);
  }
  // The browser stops an idle service worker.
  const browser = await page.context().newCDPSession(page);
  await browser.send("ServiceWorker.enable");
  await browser.send("ServiceWorker.stopAllWorkers");
  await browser.detach();
  asked.length = 0;
  await page.evaluate(() => fetch("js/main.js"));
  // The browser also checks for a new service worker at any time.
  assert.deepEqual(asked.filter((name) => name !== "service-worker.js"), ["js/main.js"]);

  server.intercept((name, response) => (name === "" ? send(response, 200, newer) : name === "words/en.json" && send(response, 503, NOT_NOW)));
  await page.reload();
  await page.waitForSelector("#not-started");
  assert.equal(visitor.errors.splice(0).length, 1, "the page reports what did not load");

  // The older version is still complete.
  server.intercept(() => true);
  await page.click("#start-again");
  await page.waitForSelector("body[data-host='open']");
  assert.ok(await page.isHidden("#not-started"));
});

test("a file that differs from the build is not stored", async ({ open, server }) => {
  const tabs = await readFile(path.join(DIST, "js/page/tabs.js"));
  server.intercept((name, response) => name === "js/page/tabs.js" && send(response, 200, `${tabs}\n// from another version\n`, "text/javascript"));
  const visitor = await open();
  const { page } = visitor;
  const isKept = () => page.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration())?.active));
  await visitor.untilLoaded();
  assert.equal(await isKept(), false);

  server.intercept();
  await page.reload();
  await visitor.untilLoaded();
  assert.equal(await isKept(), true);
  server.intercept(() => true);
  await page.reload();
  await page.waitForSelector("body[data-host='open']");
});

/**
 * @param {import("node:http").ServerResponse} response
 * @param {number} status
 * @param {string} text
 * @param {string} [type]
 */
function send(response, status, text, type = "text/html; charset=utf-8") {
  return Boolean(response.writeHead(status, { "content-type": type }).end(text));
}
