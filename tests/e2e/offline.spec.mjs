import assert from "node:assert/strict";
import { createReadStream } from "node:fs";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { variants, test } from "./fixtures.mjs";
import { DIST, inVersion, versionIn } from "./server.mjs";

test.use({ visit: { serviceWorkers: "allow" } });

/** Names of versions that no browser has stored. */
const [NEWER, NEWEST] = ["0123456789abcdef", "123456789abcdef0"];

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

for (const [[what, interceptor], tag] of variants([["is unreachable"], ...Object.entries(FAULTS)])) {
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
    await page.waitForSelector("#verdict[data-tone='success']");
    // Its script loads later than the page's.
    assert.equal((await visitor.save("download-picture")).name, "sample-view.png");
  });
}

test("a page of a newer version loads its files from the network, or reports that it did not load", async ({ visitor, page, server }) => {
  await visitor.untilLoaded();
  const version = await versionIn(DIST);
  const newer = String(await readFile(path.join(DIST, "index.html"))).replaceAll(version, NEWER);
  /** @type {string[]} */
  const asked = [];
  const answer = (name, response) => {
    asked.push(name);
    if (name === "") return send(response, 200, newer);
    if (!name.startsWith(NEWER)) return false;
    response.writeHead(200, { "content-type": { ".css": "text/css", ".wasm": "application/wasm" }[path.extname(name)] ?? "text/javascript" });
    createReadStream(path.join(DIST, version, path.basename(name))).pipe(response);
    return true;
  };
  server.intercept(answer);
  await page.reload();
  await page.waitForSelector("#language option", { state: "attached" });
  for (const file of ["start.js", "page.js", "page.css", "rosto-studio-web_bg.wasm"]) assert.ok(asked.includes(`${NEWER}/${file}`), file);

  const newest = newer.replaceAll(NEWER, NEWEST);
  server.intercept((name, response) => (name === "" ? send(response, 200, newest) : name.startsWith(NEWEST) && send(response, 503, NOT_NOW)));
  await page.reload();
  await page.waitForSelector("#not-started");

  // The older version is still complete.
  server.intercept(() => true);
  await page.click("#start-again");
  await page.waitForSelector("body[data-host='open']");
  assert.ok(await page.isHidden("#not-started"));
});

test("a file that differs from the build is not stored", async ({ open, server }) => {
  const icon = await inVersion("rosto-512.png");
  server.intercept((name, response) => name === icon && send(response, 200, "another icon", "image/png"));
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
 * @param {string | Buffer} text
 * @param {string} [type]
 */
function send(response, status, text, type = "text/html; charset=utf-8") {
  return Boolean(response.writeHead(status, { "content-type": type }).end(text));
}
