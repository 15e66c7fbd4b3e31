// Notices after failures are correct and stay until dismissed.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { SAMPLE } from "./visitor.mjs";
import { crashBefore, recordGpus } from "./page-scripts.mjs";

test.use({ visit: { scripts: [recordGpus] } });

/** Opens the sample and moves the nose tip; returns the mesh. */
async function work(visitor) {
  await visitor.openFace();
  await visitor.move("nose tip", "z", 7);
  return visitor.meshJson("mm");
}

/** Presses a button that saves a file, and expects a notice and no file. */
async function failToSave(visitor, action) {
  const { page } = visitor;
  const files = [];
  page.on("download", (download) => files.push(download.suggestedFilename()));
  await visitor.showButton(action);
  await page.click(`#panel [data-action="${action}"]`);
  const notice = await visitor.notice();
  await visitor.frames(10);
  assert.deepEqual(files, [], "a file was saved");
  return notice;
}

test("the open work stays when memory runs out while another file opens", async ({ visitor, page }) => {
  const mesh = await work(visitor);
  await page.evaluate(() => {
    const create = globalThis.createImageBitmap;
    globalThis.createImageBitmap = () => {
      globalThis.createImageBitmap = create;
      return Promise.reject(new RangeError("Array buffer allocation failed"));
    };
  });
  await visitor.drop(await readFile(SAMPLE), "again.png");
  assert.match((await visitor.notice()).text, /still here/);
  assert.deepEqual(await visitor.history(), ["nose tip"]);
  assert.deepEqual(await visitor.meshJson("mm"), mesh);
  await visitor.drop(await readFile(SAMPLE), "again.png");
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 0);
});

for (const { loss, lose, label, code } of [
  { loss: "the GPU", lose: loseGpu, code: "not-drawn" },
  { loss: "memory for the picture", lose: starve, label: "still", code: "no-memory" },
  { loss: "memory for the render target", lose: starve, label: "attachment", code: "no-memory" },
]) {
  test(`a picture that fails because ${loss} is lost is not saved, and the notice stays until dismissed`, async ({ visitor, page }) => {
    const mesh = await work(visitor);
    const gpus = await page.evaluate("gpus.length");
    await page.evaluate(lose, label);
    const notice = await failToSave(visitor, "download-picture");
    assert.equal(notice.code, code);
    if (code === "no-memory") assert.match(notice.text, /smaller/);
    else await page.waitForFunction((gpus) => window.gpus.length > gpus, gpus);
    await visitor.frames(20);
    assert.deepEqual(await visitor.notice(), notice);
    await page.keyboard.press("Escape");
    assert.ok(await page.isHidden("#notice"));
    assert.ok((await visitor.download("download-picture")).length > 10_000);
    assert.deepEqual(await visitor.meshJson("mm"), mesh);
  });
}

for (const { reply, action, code } of [
  { reply: "edited-photo", action: "download-photo-png", code: "photo-not-written" },
  { reply: "write", action: "download-glb", code: "file-not-written" },
]) {
  test(`the notice names the right task if the worker crashes before the reply ${reply}`, async ({ visitor, page }) => {
    await visitor.untilLoaded();
    const mesh = await work(visitor);
    await Promise.all(page.workers().map((worker) => worker.evaluate(crashBefore, reply)));
    const notice = await failToSave(visitor, action);
    assert.equal(notice.code, code);
    assert.doesNotMatch(notice.text, /[Rr]eading/);
    assert.deepEqual(await visitor.meshJson("mm"), mesh);
  });
}

test("a notice appears over an open dialog, can be closed there, and returns to the stage afterwards", async ({ editor, page }) => {
  const dropWords = () => editor.drop(Buffer.from("words"), "words.txt");
  const isOnTop = () => page.evaluate(() => {
    const notice = document.getElementById("notice");
    const { left, top, width, height } = notice.getBoundingClientRect();
    return notice.contains(document.elementFromPoint(left + width / 2, top + height / 2));
  });

  await page.focus("#viewport");
  await page.keyboard.press("?");
  await page.waitForSelector("#keys[open]");
  await dropWords();
  await page.waitForSelector("#notice");
  assert.ok(await isOnTop(), "the notice is beneath the dialog");
  await page.click("#notice-close");
  assert.ok(await page.isHidden("#notice"));
  assert.ok(await page.isVisible("#keys"));

  await dropWords();
  await page.click("[data-action='close-keys']");
  await page.waitForSelector("#notice:not(dialog #notice)");
  assert.ok(await isOnTop());

  // A visible notice moves into the dialog.
  await page.focus("#viewport");
  await page.keyboard.press("?");
  await page.waitForSelector("#keys[open]");
  await page.waitForSelector("dialog #notice");
  assert.ok(await isOnTop());
});

/** Runs in the page: destroys the GPU device with the next picture. */
function loseGpu() {
  const map = GPUBuffer.prototype.mapAsync;
  GPUBuffer.prototype.mapAsync = function (...how) {
    GPUBuffer.prototype.mapAsync = map;
    window.gpus.at(-1).device.destroy();
    return map.apply(this, how);
  };
}

/** Runs in the page: asks for the next texture with this label in an impossible size. */
function starve(label) {
  const create = GPUDevice.prototype.createTexture;
  GPUDevice.prototype.createTexture = function (wanted) {
    if (wanted.label !== label) return create.call(this, wanted);
    GPUDevice.prototype.createTexture = create;
    const side = this.limits.maxTextureDimension2D;
    const size = { width: side, height: side, depthOrArrayLayers: this.limits.maxTextureArrayLayers };
    return create.call(this, { ...wanted, size, sampleCount: 1, format: "rgba16float" });
  };
}
