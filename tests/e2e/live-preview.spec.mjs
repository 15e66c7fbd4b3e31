// Live preview: the camera on the stage, with the edits of the open face.
import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { findings } from "./boxes.mjs";
import { camera, recordCamera, rejectIn } from "./camera-watch.mjs";
import { portraitLandmarks } from "./video.mjs";
import { FRAMES_PER_S, HEIGHT_PX, SPEED_PX_S, WIDTH_PX, mapToFrame, numberOf, poseIn } from "./video-frames.mjs";
import { test } from "./fixtures.mjs";
import { PREVIOUS_FACE } from "./groups.mjs";
import { differenceNear, meanColour } from "./pixels.mjs";
import { crashBefore } from "./page-scripts.mjs";

/** @typedef {import("./visitor.mjs").Visitor} Visitor */
/** @typedef {import("./pixels.mjs").Pixels} Pixels */

const NOSE_TIP = 4;
const NOSE_MM = 5;
/** Maximum delay of the edit behind the face. */
const LAG_S = 0.06;

test.use({ visit: { expert: true, scripts: [recordCamera, watchFrames] } });

test("the live preview mirrors the camera and shows the edits on the face", { tag: "@seen-camera" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.setSlider("nose-width", NOSE_MM);
  await openLivePreview(visitor);
  assert.ok((await figures(visitor)).frames > 0);

  const nose = (await portraitLandmarks())[NOSE_TIP];
  for (let time = 0; time < 3; time += 1) {
    await visitor.frames(30);
    // Stops new frames and waits for pending ones.
    await page.evaluate("isFrozen = true");
    await page.waitForFunction(() => window.following === 0);
    const now = await streamOf(visitor);
    await page.focus("#viewport");
    await page.keyboard.down("b");
    const unedited = await streamOf(visitor);
    await page.keyboard.up("b");
    await page.evaluate("isFrozen = false");

    // In the video, the background is redder towards the right.
    const [left] = meanColour(now, { left: 0.02, right: 0.1, top: 0.1, bottom: 0.3 });
    const [right] = meanColour(now, { left: 0.9, right: 0.98, top: 0.1, bottom: 0.3 });
    assert.ok(right > left + 100, `the preview is not mirrored: ${left}, ${right}`);

    const number = numberOf(unedited);
    const [x, y] = mapToFrame(poseIn(number), nose);
    assert.ok(differenceNear(now, unedited, { x, y }, 24) > 0.1, "the nose has not changed");
    for (const [cx, cy] of [[40, 40], [600, 40], [40, 400], [600, 440]]) {
      assert.equal(differenceNear(now, unedited, { x: cx, y: cy }, 24), 0, "a corner of the video has changed");
    }
    const off_px = middleOfChange(now, unedited) - x;
    assert.ok(Math.abs(off_px) < SPEED_PX_S * LAG_S, `in frame ${number} the edit is ${off_px} px off the nose`);
  }
  await page.click("#live-close");
  assert.equal((await camera(visitor)).live, 0);
});

test("the live preview can be saved as a photo with its edits, and the camera stops", { tag: "@moving-camera" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.setSlider("nose-width", NOSE_MM);
  await openLivePreview(visitor);
  // An edit made during the preview is saved, too.
  await visitor.setSlider("eye-size", 2);
  await page.click("#live-save");
  await page.waitForSelector("#live", { state: "hidden" });
  await page.waitForSelector(`${PREVIOUS_FACE}:visible`);
  await visitor.untilFace();
  assert.equal((await visitor.history()).length, 2);
  assert.equal(await visitor.sliderValue("nose-width"), NOSE_MM);
  assert.equal(await visitor.sliderValue("eye-size"), 2);
  assert.deepEqual(await camera(visitor), { asked: 1, tracks: 1, live: 0 });
});

test("without an open face, the live preview opens the first face, and a double click opens one camera", { tag: "@moving-camera" }, async ({ open }) => {
  const visitor = await open({ viewport: { width: 390, height: 844 } });
  const { page } = visitor;
  await visitor.untilLoaded();
  await page.dblclick("#welcome [data-action='live-preview']");
  await visitor.untilFace();
  await untilShown(visitor);
  assert.equal(await page.getAttribute("body", "data-scene"), "picture");
  // The face rests for a part of the video.
  await expect(async () => {
    const { age, interval_ms, jitter_px } = await figures(visitor);
    assert.ok(age <= 1 + (2 * interval_ms * FRAMES_PER_S) / 1000, `${age} frames old, every ${interval_ms} ms`);
    assert.ok(jitter_px < 0.3, `jitter of ${jitter_px} px`);
  }).toPass({ timeout: 30_000, intervals: [200] });
  assert.deepEqual(await findings(page), [], "layout on a phone");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#live", { state: "hidden" });
  assert.equal(await page.getAttribute("body", "data-state"), "face");
  assert.deepEqual(await camera(visitor), { asked: 1, tracks: 1, live: 0 });
  assert.equal(await page.getAttribute("#privacy-count", "data-requests"), "0", "a request was made");
});

test("the live preview handles lost faces, worker crashes and hidden pages", { tag: "@moving-camera" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await openLivePreview(visitor);
  await page.evaluate(() => (window.isBlank = true));
  await page.waitForFunction(() => document.getElementById("live-status").textContent === "No face in view");
  assert.ok(await page.isDisabled("#live-save"));
  await page.evaluate(() => (window.isBlank = false));
  await page.waitForSelector("#live-save:enabled");

  await page.evaluate(refuseFrame);
  await page.waitForFunction(() => window.isFrameRefused);
  await page.waitForSelector("#live-save:enabled");
  assert.ok(await page.isHidden("#notice"), "a missing frame is reported");

  await page.workers()[0].evaluate(crashBefore, "follow");
  assert.equal((await visitor.notice()).code, "worker-died");
  await page.waitForSelector("#live-save:enabled");

  await show(visitor, "hidden");
  await page.waitForFunction(() => window.cameraTracks.every(({ readyState }) => readyState === "ended"));
  await show(visitor, "visible");
  await page.waitForSelector("#live-save:enabled");
  assert.deepEqual(await camera(visitor), { asked: 2, tracks: 2, live: 1 });

  // The photo camera takes over.
  await visitor.unfold("section-photo");
  await page.click("#section-photo [data-action='camera']");
  await page.waitForSelector("#camera-shutter:enabled");
  assert.ok(await page.isHidden("#live"));
  assert.equal((await camera(visitor)).live, 1);
});

test("a refused or unplugged camera closes the live preview with a notice", { tag: "@moving-camera" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();
  await page.evaluate(() => (window.isRefused = true));
  await page.click("#welcome [data-action='live-preview']");
  assert.equal((await visitor.notice()).code, "camera-refused");
  assert.ok(await page.isHidden("#live"));
  await page.evaluate(() => (window.isRefused = false));
  await visitor.dropSample();
  await openLivePreview(visitor);
  await page.evaluate(() => window.unplugCamera());
  assert.equal((await visitor.notice()).code, "camera-lost");
  assert.ok(await page.isHidden("#live"));
  assert.equal((await camera(visitor)).live, 0);
  // The photo and its 3D view are restored.
  await page.waitForFunction(() => document.body.dataset.scene === "solid");
});

test("a live preview closed while it starts, or that cannot play or read a frame, leaves no unhandled rejection", { tag: "@moving-camera" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();
  for (let time = 0; time < 3; time += 1) {
    await page.click("#welcome [data-action='live-preview']");
    await page.keyboard.press("Escape");
    await page.waitForSelector("#live", { state: "hidden" });
  }
  await page.waitForFunction(() => window.cameraTracks.every(({ readyState }) => readyState === "ended"));
  assert.ok(await page.isHidden("#notice"));

  // The first frame with a face opens as a photo.
  await page.evaluate(rejectIn, ["OffscreenCanvas", "convertToBlob"]);
  await page.click("#welcome [data-action='live-preview']");
  assert.equal((await visitor.notice()).code, "other");
  await page.waitForSelector("#live", { state: "hidden" });

  await page.evaluate(rejectIn, ["HTMLMediaElement", "play"]);
  await page.click("#welcome [data-action='live-preview']");
  await page.waitForSelector("#notice[data-code='no-camera']");
  assert.ok(await page.isHidden("#live"));
  assert.equal((await camera(visitor)).live, 0);
  assert.deepEqual(await page.evaluate(() => window.rejections), []);
});

/** Runs in the page: its next frame cannot be read. */
function refuseFrame() {
  const { createImageBitmap } = window;
  window.createImageBitmap = () => {
    Object.assign(window, { createImageBitmap, isFrameRefused: true });
    return Promise.reject(new DOMException("The image source is not usable", "InvalidStateError"));
  };
}

/** Opens the live preview over the open face and waits until the stage shows it. @param {Visitor} visitor */
async function openLivePreview(visitor) {
  await visitor.unfold("section-photo");
  await visitor.page.click("#section-photo [data-action='live-preview']");
  await untilShown(visitor);
}

/** @param {Visitor} visitor */
async function untilShown(visitor) {
  await visitor.page.waitForSelector("#live-save:enabled");
  await visitor.page.waitForSelector("#live-video", { state: "hidden" });
  if (!(await visitor.page.isVisible("#live-figures"))) await visitor.page.click("#live-figures-shown");
  await visitor.page.waitForSelector("#live-figures[data-frames]:not(:empty)");
}

/** @param {Visitor} visitor */
function figures({ page }) {
  const numbers = ({ dataset }) => Object.fromEntries(Object.entries(dataset).map(([name, value]) => [name, Number(value)]));
  return page.locator("#live-figures").evaluate(numbers);
}

/** The preview as the stage shows it, unmirrored and at the camera's size. @param {Visitor} visitor */
async function streamOf(visitor) {
  const view = await visitor.view();
  const covered = await visitor.page.evaluate(() => {
    const [stage, bar, toolbar] = ["viewport", "live", "toolbar"].map((id) => document.getElementById(id).getBoundingClientRect());
    return { top: bar.bottom + 8 - stage.top, bottom: toolbar.top - 8 - stage.top };
  });
  const scale = Math.min(view.width / WIDTH_PX, (covered.bottom - covered.top) / HEIGHT_PX);
  const middle = { x: view.width / 2, y: (covered.top + covered.bottom) / 2 };
  const data = new Uint8Array(4 * WIDTH_PX * HEIGHT_PX);
  for (let y = 0; y < HEIGHT_PX; y += 1) {
    for (let x = 0; x < WIDTH_PX; x += 1) {
      const from_x = Math.floor(middle.x - (x + 0.5 - WIDTH_PX / 2) * scale);
      const from_y = Math.floor(middle.y + (y + 0.5 - HEIGHT_PX / 2) * scale);
      const from = 4 * (from_y * view.width + from_x);
      data.set(view.data.subarray(from, from + 4), 4 * (y * WIDTH_PX + x));
    }
  }
  return { width: WIDTH_PX, height: HEIGHT_PX, data };
}

/** Mean x position of the differences between two pictures, px. @param {Pixels} a @param {Pixels} b */
function middleOfChange(a, b) {
  let [sum, weights] = [0, 0];
  for (let at = 0; at < a.data.length; at += 4) {
    const weight = Math.max(...[0, 1, 2].map((channel) => Math.abs(a.data[at + channel] - b.data[at + channel])));
    sum += weight * ((at / 4) % a.width);
    weights += weight;
  }
  return sum / weights;
}

/** Simulates a change of the page's visibility. @param {Visitor} visitor @param {string} state */
function show({ page }, state) {
  return page.evaluate((state) => {
    Object.defineProperty(document, "visibilityState", { configurable: true, get: () => state });
    document.dispatchEvent(new Event("visibilitychange"));
  }, state);
}

/** Runs in the page before its own scripts: can block frames, blank them, and counts frames without a reply. */
function watchFrames() {
  const bitmapOf = window.createImageBitmap.bind(window);
  window.createImageBitmap = async (source, ...options) => {
    if (source instanceof HTMLVideoElement && window.isFrozen) return new Promise(() => {});
    if (source instanceof HTMLVideoElement && window.isBlank) return bitmapOf(new ImageData(new Uint8ClampedArray(4 * 640 * 480).fill(200), 640));
    return bitmapOf(source, ...options);
  };
  window.following = 0;
  const { postMessage } = Worker.prototype;
  Worker.prototype.postMessage = function (message, ...rest) {
    postMessage.call(this, message, ...rest);
    if (message.type !== "follow") return;
    window.following += 1;
    const onReply = ({ data }) => {
      if (data.id !== message.id) return;
      window.following -= 1;
      this.removeEventListener("message", onReply);
    };
    this.addEventListener("message", onReply);
  };
}
