import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { withHeld } from "./held.mjs";
import { colourCount } from "./pixels.mjs";
import { faceless } from "./pictures.mjs";
import { DIST } from "./server.mjs";
import { SAMPLE } from "./visitor.mjs";
import { dieBefore, watchWorkers } from "./watches.mjs";

const WORKER_MODULE = "**/rosto-vision-web_bg.wasm";

test("the page draws and answers before the worker's module has arrived", { tag: "@eyes" }, async ({ open }) => {
  const { before, deliver } = withHeld(WORKER_MODULE);
  const visitor = await open({ before });
  await visitor.page.waitForSelector("body[data-bench='open']");
  assert.ok(colourCount(await visitor.view()) > 4, "the canonical face is not drawn");
  await visitor.page.selectOption("#language", "pt");
  assert.equal(await visitor.page.innerText("#welcome-title"), "Solte aqui a foto de um rosto");
  await visitor.page.selectOption("#language", "en");
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await visitor.page.waitForSelector("#progress-title:has-text('Loading the face networks')");
  deliver();
  await visitor.untilFace();
});

test("a worker that dies is started again, and the work on screen stays", async ({ visitor }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 7);
  const work = await visitor.meshJson("mm");

  const [dying] = visitor.page.workers();
  const next = visitor.page.waitForEvent("worker");
  await dying.evaluate(() => self.close()).catch(() => {});
  await next;
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
  await visitor.page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
});

test("a photo that takes the worker down leaves the work and a message", async ({ visitor }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 7);
  const work = await visitor.meshJson("mm");

  const [dying] = visitor.page.workers();
  await dying.evaluate(dieBefore, "found");
  await visitor.drop(faceless(), "trap.png");
  assert.equal((await visitor.notice()).code, "worker-died");
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
});

test("a worker that never comes is given up after a minute, and the next photo starts another", { tag: "@rare" }, async ({ open }) => {
  let silences = true;
  let asked = 0;
  const visitor = await open({
    hasClock: true,
    before: (context) =>
      context.route(WORKER_MODULE, (route) => {
        asked += 1;
        return silences ? undefined : route.continue();
      }),
  });
  const { page } = visitor;
  await page.waitForSelector("body[data-bench='open']");
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await page.waitForSelector("#progress-title:has-text('Loading the face networks')");
  await expect.poll(() => asked).toBeGreaterThan(0);
  await visitor.frames(5);
  await page.clock.fastForward(50_000);
  assert.ok(await page.isVisible("#progress"), "it was given up too soon");
  await page.clock.fastForward(15_000);
  const { code, text } = await visitor.notice();
  assert.equal(code, "not-loaded");
  assert.match(text, /try again/);
  assert.ok(await page.isHidden("#progress"));

  silences = false;
  await visitor.dropSample();
  assert.ok(await page.isHidden("#notice"));
});

test("a worker on a slow connection is waited for", async ({ open, server }) => {
  const module = "wasm/rosto-vision-web_bg.wasm";
  const bytes = await readFile(path.join(DIST, module));
  const piece_bytes = Math.ceil(bytes.length / 100);
  /** @type {import("node:http").ServerResponse | undefined} */
  let response;
  server.disturb((name, answer) => {
    if (name !== module) return false;
    response = answer.writeHead(200, { "content-type": "application/wasm", "content-length": bytes.length });
    return true;
  });
  const visitor = await open({ hasClock: true, scripts: [watchWorkers] });
  const { page } = visitor;
  await page.waitForSelector("body[data-bench='open']");
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await page.waitForSelector("#progress-title:has-text('Loading the face networks')");
  const reports = () => page.evaluate(() => window.workersSaid.filter((type) => type === "loading").length);
  let at = 0;
  for (let wait = 0; wait < 5; wait += 1) {
    const before = await reports();
    // The worker reports at most once in a second that something arrives.
    await expect.poll(() => {
      at += piece_bytes;
      response?.write(bytes.subarray(at - piece_bytes, at));
      return reports();
    }, { intervals: [200] }).toBeGreaterThan(before);
    await page.clock.fastForward(40_000);
  }
  response?.end(bytes.subarray(at));
  await visitor.untilFace();
  assert.ok(await page.isHidden("#notice"));
});

test("the bar shows how much of the whole is done, and never goes back", async ({ open }) => {
  const visitor = await open({ scripts: [watchProgress] });
  for (let photo = 0; photo < 2; photo += 1) {
    await visitor.page.evaluate(() => window.told.splice(0));
    await visitor.dropSample();
    const told = await visitor.page.evaluate(() => window.told);
    assert.ok(told.length >= 3);
    for (const { fraction, bar } of told) assert.equal(bar, fraction);
    const bars = told.map(({ bar }) => bar);
    assert.deepEqual(bars, bars.toSorted((a, b) => a - b));
  }
});

/** Runs in the page before its own scripts. */
function watchProgress() {
  window.told = [];
  const listen = Worker.prototype.addEventListener;
  Worker.prototype.addEventListener = function (type, listener, ...rest) {
    listen.call(this, type, listener, ...rest);
    if (type !== "message") return;
    listen.call(this, type, ({ data: { type, fraction } }) => {
      if (type === "progress") window.told.push({ fraction, bar: document.getElementById("progress-bar").value });
    });
  };
}
