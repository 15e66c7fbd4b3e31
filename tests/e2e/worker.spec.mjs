import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { delayFile } from "./delayed-file.mjs";
import { colourCount } from "./pixels.mjs";
import { faceless } from "./pictures.mjs";
import { DIST, inVersion } from "./server.mjs";
import { SAMPLE } from "./visitor.mjs";
import { crashBefore, recordWorkers } from "./page-scripts.mjs";

const WORKER_MODULE = "**/rosto-vision-web_bg.wasm";

test("the page draws and responds before the worker's module has loaded", { tag: "@eyes" }, async ({ open }) => {
  const { before, deliver } = delayFile(WORKER_MODULE);
  const visitor = await open({ before });
  await visitor.page.waitForSelector("body[data-host='open']");
  assert.ok(colourCount(await visitor.view()) > 4, "the canonical face is not drawn");
  await visitor.page.selectOption("#language", "pt");
  assert.equal(await visitor.page.innerText("#welcome-title"), "Solte aqui a foto de um rosto");
  await visitor.page.selectOption("#language", "en");
  await untilNetworksLoad(visitor);
  deliver();
  await visitor.untilFace();
});

test("a crashed worker restarts and leaves the work unchanged", async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 7);
  const work = await visitor.meshJson("mm");

  const next = page.waitForEvent("worker");
  await page.workers()[0].evaluate(() => self.close()).catch(() => {});
  const worker = await next;
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
  await expect(page.locator("#history .check")).toHaveCount(0);

  await visitor.move("nose tip", "z", 7);
  await worker.evaluate(crashBefore, "open");
  await visitor.drop(faceless(), "trap.png");
  assert.equal((await visitor.notice()).code, "worker-died");
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
});

test("a worker that does not load times out after a minute, and the next photo starts another one", async ({ open }) => {
  const visitor = await open({ hasClock: true, before: (context) => context.route(WORKER_MODULE, () => {}) });
  const { page, requests } = visitor;
  await page.waitForSelector("body[data-host='open']");
  await untilNetworksLoad(visitor);
  await expect.poll(() => requests.join()).toContain(path.basename(WORKER_MODULE));
  await visitor.frames(5);
  await page.clock.fastForward(50_000);
  assert.ok(await page.isVisible("#progress"), "the timeout came too early");
  await page.clock.fastForward(15_000);
  const { code, text } = await visitor.notice();
  assert.equal(code, "not-loaded");
  assert.match(text, /try again/);
  assert.ok(await page.isHidden("#progress"));

  await page.context().unroute(WORKER_MODULE);
  await visitor.dropSample();
  assert.ok(await page.isHidden("#notice"));
});

test("a worker on a slow connection does not time out", async ({ open, server }) => {
  const module = await inVersion(path.basename(WORKER_MODULE));
  const bytes = await readFile(path.join(DIST, module));
  const piece_bytes = Math.ceil(bytes.length / 100);
  /** @type {import("node:http").ServerResponse | undefined} */
  let response;
  server.intercept((name, answer) => {
    if (name !== module) return false;
    response = answer.writeHead(200, { "content-type": "application/wasm", "content-length": bytes.length });
    return true;
  });
  const visitor = await open({ hasClock: true, scripts: [recordWorkers] });
  const { page } = visitor;
  await page.waitForSelector("body[data-host='open']");
  await untilNetworksLoad(visitor);
  const reports = () => page.evaluate(() => window.workerMessages.filter((type) => type === "loading").length);
  let at = 0;
  for (let wait = 0; wait < 5; wait += 1) {
    const before = await reports();
    // The worker reports progress at most once per second.
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

test("the progress bar shows the total progress and does not go back", async ({ open }) => {
  const visitor = await open({ scripts: [recordWorkers] });
  for (let photo = 0; photo < 2; photo += 1) {
    await visitor.page.evaluate("workerProgress.length = 0");
    await visitor.dropSample();
    const progress = await visitor.page.evaluate("workerProgress");
    assert.ok(progress.length >= 3);
    for (const { fraction, bar } of progress) assert.equal(bar, fraction);
    const bars = progress.map(({ bar }) => bar);
    assert.deepEqual(bars, bars.toSorted((a, b) => a - b));
  }
});

/**
 * Drops the sample and waits until the page waits for the networks.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 */
async function untilNetworksLoad(visitor) {
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await visitor.page.waitForSelector("#progress-title:has-text('Loading face detection')");
}
