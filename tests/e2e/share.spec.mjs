import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { PREVIOUS_FACE } from "./groups.mjs";
import { difference, differenceNear } from "./pixels.mjs";
import { crashGpu, hookModule, recordGpus } from "./page-scripts.mjs";

/** Time limit for a recording on a slow machine. */
const CLIP_MS = 120_000;

/** Gap as in pictures.ts, as a fraction of the picture's height. */
const GAP = 0.008;

test("before and after are saved as halves of one picture, and the view does not change", { tag: "@eyes" }, async ({ visitor }) => {
  await visitor.openFace("ana");
  const found = PNG.sync.read(await visitor.download("download-picture"));
  await visitor.move("nose tip", "x", 12);
  const place = await visitor.toViewPixels(await visitor.selectionPosition());
  const edited = PNG.sync.read(await visitor.download("download-picture"));
  const before = await readState(visitor);
  const { name, bytes } = await visitor.save("download-pair");
  assert.equal(name, "ana-before-after.png");
  const pair = PNG.sync.read(bytes);
  const width = (pair.width - Math.round(GAP * pair.height)) / 2;
  const [left, right] = [cut(pair, 0, width), cut(pair, pair.width - width, width)];
  const overCaption = Math.floor(0.92 * pair.height);
  for (const [half, alone] of [[left, found], [right, edited]]) {
    const middle = cut(alone, (alone.width - width) / 2, width);
    const over = difference(cut(half, 0, width, overCaption), cut(middle, 0, width, overCaption));
    assert.equal(over, 0, "a half differs from the picture saved separately");
    // "After" is shorter than "Before".
    assert.ok(difference(half, middle) > (half === left ? 0.0004 : 0.0003), "the caption is missing");
  }
  const nose = { x: left.width / 2 + 2 * (place.x - before.view.width / 2), y: 2 * place.y };
  assert.ok(differenceNear(left, right, nose, 60) > 0.2, "the halves show the same nose");
  assert.equal(differenceNear(left, right, { x: 40, y: 40 }, 30), 0, "they differ where nothing was edited");
  assertSame(await readState(visitor), before);
});

test("a before/after picture that fails shows a notice and leaves the view unchanged", { tag: "@eyes" }, async ({ open }) => {
  const editor = await open({ scripts: [hookModule] });
  const { page } = editor;
  await editor.openFace();
  await editor.move("nose tip", "x", 12);
  const before = await readState(editor);
  await page.evaluate(failPictures);
  await editor.openSaveMenu();
  await page.click("[data-action='download-pair']");
  assert.equal((await editor.notice()).code, "not-drawn");
  assertSame(await readState(editor), before);
});

test("pictures are shared if possible, and downloaded if sharing fails", async ({ open }) => {
  const visitor = await open({ scripts: [installSharing] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.move("nose tip", "z", 4);
  await page.click("#save-share");
  await page.waitForFunction(() => window["sent"].length === 1);
  const [sent] = await page.evaluate("sent");
  assert.deepEqual([sent.name, sent.type], ["portrait-before-after.png", "image/png"]);
  assert.ok(sent.bytes > 10_000, `${sent.bytes} bytes`);
  await page.evaluate("answer = 'NotAllowedError'");
  await Promise.all([page.waitForEvent("download"), page.click("#save-share")]);
  await page.evaluate("answer = 'AbortError'");
  await page.keyboard.press("p");
  await page.click("#save-share");
  await page.waitForFunction(() => window["sent"].length === 3);
  assert.deepEqual(await page.evaluate("[sent[2].name, sent[2].type]"), ["portrait-edited.jpg", "image/jpeg"]);
  assert.ok(await page.isHidden("#notice"));
});

test("a GLB that cannot be shared is saved; cancelling is silent", async ({ open }) => {
  const visitor = await open({ scripts: [installSharing] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.unfold("section-export");
  for (const answer of ["NotAllowedError", "DataError", "InvalidStateError", "missing"]) {
    await page.evaluate((answer) => (window["answer"] = answer), answer);
    assert.ok((await visitor.download("share-glb")).length > 0, answer);
  }
  let downloads = 0;
  page.on("download", () => (downloads += 1));
  await page.evaluate("answer = 'AbortError'");
  const attempts = await page.evaluate("sent.length");
  await page.click("#share-glb");
  await page.waitForFunction((attempts) => window["sent"].length > attempts, attempts);
  await visitor.frames(5);
  assert.equal(downloads, 0);
  assert.ok(await page.isHidden("#notice"));
});

for (const [what, script] of Object.entries({
  "has no share()": "delete Navigator.prototype.share; navigator.canShare = () => true",
  "throws in canShare()": "navigator.share = async () => {}; navigator.canShare = () => { throw new TypeError('refused') }",
})) {
  test(`the share buttons are absent in a browser that ${what}`, async ({ open }) => {
    const visitor = await open({ scripts: [script] });
    await visitor.openFace();
    await visitor.unfold("section-export");
    for (const id of ["share-glb", "save-share"]) assert.ok(await visitor.page.isHidden(`#${id}`), id);
    await visitor.openSaveMenu();
    assert.ok(await visitor.page.isVisible("#download-pair"));
  });
}

test("the face swings once in a four-second video without tools, and the view is restored", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.openFace("ana");
  await visitor.move("nose tip", "z", 8);
  const before = await readState(visitor);
  await visitor.openSaveMenu();
  const coming = page.waitForEvent("download", { timeout: CLIP_MS });
  await page.click("#clip");
  await page.waitForSelector("#clip-progress");
  assert.equal(await page.innerText("#clip"), "Cancel (Esc)");
  assert.equal(await page.innerText("#announcement"), "Recording the video");
  const download = await coming;
  assert.equal(download.suggestedFilename(), "ana-turning.webm");
  const bytes = await readFile(await download.path());
  assert.deepEqual([...bytes.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3], "the bytes are not EBML");
  assert.ok(await page.isHidden("#clip-progress"));
  assert.equal(await page.innerText("#clip"), "Rotating video");
  assert.ok(await page.locator("#clip").evaluate((button) => button === document.activeElement), "the focus was lost");
  assertSame(await readState(visitor), before);

  // A separate page, because this one's policy blocks videos.
  const player = await page.context().browser().newPage();
  const { duration_s, width, height, frames } = await player.evaluate(watch, new Uint8Array(bytes));
  await player.close();
  assert.ok(duration_s > 3.7 && duration_s < 5.5, `${duration_s} s`);
  assert.deepEqual([width, height], [720, 720]);
  const [first, ...others] = frames;
  const last = others.pop();
  const turned = others.map((frame) => difference(first, frame));
  assert.ok(Math.max(...turned) > 0.2, `the face does not turn: ${turned}`);
  assert.ok(difference(first, last) < 0.05, `the face does not return: ${difference(first, last)}`);
  assert.equal(accents(first), 0, "a tool is visible in the video");
});

for (const { by, stop } of [
  { by: "Escape", stop: (/** @type {import("@playwright/test").Page} */ page) => page.keyboard.press("Escape") },
  { by: "the button", stop: (/** @type {import("@playwright/test").Page} */ page) => page.click("#clip") },
]) {
  test(`a recording cancelled by ${by} leaves no file and no change`, { tag: "@eyes" }, async ({ editor, page }) => {
    await editor.findLandmark("nose tip");
    await page.focus("#viewport");
    await page.keyboard.press("ArrowRight");
    const before = await readState(editor);
    let downloads = 0;
    page.on("download", () => (downloads += 1));
    await recordHalf(editor);
    await stop(page);
    await page.waitForSelector("#clip-progress", { state: "hidden" });
    assert.equal(await page.innerText("#toast"), "Recording cancelled");
    await editor.frames(30);
    assert.equal(downloads, 0);
    assertSame(await readState(editor), before);
  });
}

test("a recording ends with a notice when the page is hidden", { tag: "@eyes" }, async ({ editor, page }) => {
  const before = await editor.view();
  await recordHalf(editor);
  await page.evaluate(() => document.dispatchEvent(new Event("visibilitychange")));
  await untilInterrupted(page);
  assert.equal(difference(await editor.view(), before), 0);
});

test("a recording ends when another face opens, whose view is not turned", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.openFace("another");
  await page.waitForSelector(PREVIOUS_FACE);
  await recordHalf(editor);
  await page.click(PREVIOUS_FACE);
  await untilInterrupted(page);
  await editor.untilFace();
  const opened = await editor.view();
  await page.click("#toolbar [data-action='reset-view']");
  assert.equal(difference(await editor.view(), opened), 0, "the recording turned the new face");
});

test("a recording ends when the GPU process crashes, and a new one works", { tag: "@eyes" }, async ({ open }) => {
  const visitor = await open({ scripts: [recordGpus] });
  const { page } = visitor;
  await visitor.openFace();
  await recordHalf(visitor);
  const gpus = await page.evaluate("gpus.length");
  await crashGpu(page);
  await page.waitForSelector("#clip-progress", { state: "hidden", timeout: CLIP_MS });
  await page.waitForFunction((gpus) => window.gpus.length > gpus, gpus);
  const coming = page.waitForEvent("download", { timeout: CLIP_MS });
  await page.click("#clip");
  assert.equal((await coming).suggestedFilename(), "portrait-turning.webm");
});

test("a browser without MediaRecorder shows a note instead of the button", async ({ open }) => {
  const visitor = await open({ scripts: ["delete window.MediaRecorder"] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.openSaveMenu();
  assert.ok(await page.isHidden("#clip"));
  assert.equal(await page.innerText("#clip-line"), "This browser can’t record the video. Try another browser.");
  await visitor.setLanguage("pt");
  assert.equal(await page.innerText("#clip-line"), "Este navegador não consegue gravar o vídeo. Tente outro navegador.");
});

/** State that pictures and recordings must not change. @param {import("./visitor.mjs").Visitor} visitor */
async function readState(visitor) {
  const mesh = await visitor.meshJson("mm");
  return { mesh, history: await visitor.history(), view: await visitor.view() };
}

/** @param {Awaited<ReturnType<typeof readState>>} now @param {Awaited<ReturnType<typeof readState>>} before */
function assertSame(now, before) {
  assert.deepEqual([now.mesh, now.history], [before.mesh, before.history]);
  assert.equal(difference(now.view, before.view), 0, "the view is not what it was");
}

/** Starts a recording and waits until part of it is done. @param {import("./visitor.mjs").Visitor} visitor */
async function recordHalf(visitor) {
  await visitor.openSaveMenu();
  await visitor.page.click("#clip");
  await visitor.page.waitForFunction(() => document.getElementById("clip-progress").value > 0.2);
}

/** @param {import("@playwright/test").Page} page */
async function untilInterrupted(page) {
  await page.waitForSelector("#clip-line");
  assert.match(await page.innerText("#clip-line"), /interrupted/);
  assert.ok(await page.isHidden("#clip-progress"));
}

/** @param {PNG} picture @param {number} left @param {number} width @param {number} [height] from the top */
function cut(picture, left, width, height = picture.height) {
  const part = new PNG({ width, height });
  PNG.bitblt(picture, part, left, 0, width, height, 0, 0);
  return part;
}

/** Number of pixels in the markers' red. @param {import("./pixels.mjs").Pixels} pixels */
function accents({ data }) {
  let count = 0;
  for (let at = 0; at < data.length; at += 4) if (data[at] > 200 && data[at + 1] < 100 && data[at + 2] < 80) count += 1;
  return count;
}

/** Runs in a page: decodes some frames of a video. @param {Uint8Array} bytes */
async function watch(bytes) {
  const side = 180;
  const video = document.createElement("video");
  const eventOf = (/** @type {string} */ event) => new Promise((resolve) => video.addEventListener(event, resolve, { once: true }));
  const loaded = eventOf("loadeddata");
  video.src = URL.createObjectURL(new Blob([bytes], { type: "video/webm" }));
  await loaded;
  const context = new OffscreenCanvas(side, side).getContext("2d", { willReadFrequently: true });
  // `seeked` fires before the frame is displayed.
  const shown = async (/** @type {number} */ time_s) => {
    const frame = () => new Promise((resolve) => video.requestVideoFrameCallback((_, { mediaTime }) => resolve(mediaTime)));
    while (Math.abs((await frame()) - time_s) > 0.5);
  };
  const late = () => new Promise((resolve) => setTimeout(resolve, 2000));
  const frames = [];
  for (const share of [0, 0.25, 0.5, 0.75, 1]) {
    const there = Promise.all([eventOf("seeked"), Promise.race([shown(share * video.duration), late()])]);
    video.currentTime = share * video.duration;
    await there;
    context.drawImage(video, 0, 0, side, side);
    frames.push({ width: side, height: side, data: context.getImageData(0, 0, side, side).data });
  }
  return { duration_s: video.duration, width: video.videoWidth, height: video.videoHeight, frames };
}

/** Runs in the page: the second snapshot fails. */
function failPictures() {
  let asked = 0;
  globalThis.hooked.instead["studio_snapshot"] = (call, ...values) => {
    asked += 1;
    if (asked % 2 === 0) throw Object.assign(new Error("refused"), { code: "not-drawn" });
    return call(...values);
  };
}

/** Runs in the page before its own scripts: implements sharing, or rejects it with the error named by `answer`. */
function installSharing() {
  window["sent"] = [];
  navigator.canShare = () => true;
  navigator.share = async ({ files: [{ name, type, size }] }) => {
    window["sent"].push({ name, type, bytes: size });
    if (window["answer"] === "missing") throw new TypeError("navigator.share is not a function");
    if (window["answer"]) throw new DOMException("refused", window["answer"]);
  };
}
