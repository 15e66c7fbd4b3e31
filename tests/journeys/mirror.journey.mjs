// The mirror: the camera on the stage, with the edits of the face that is open.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { expect } from "@playwright/test";
import { findings } from "./boxes.mjs";
import { camera, watchCamera } from "./camera-watch.mjs";
import { FRAMES_PER_S, HEIGHT_PX, WIDTH_PX, carried, numberOf, placeIn } from "./film-frames.mjs";
import { test } from "./fixtures.mjs";
import { differenceNear, meanColour } from "./pixels.mjs";

/** @typedef {import("./visitor.mjs").Visitor} Visitor */

const GOLDEN = path.join(import.meta.dirname, "../golden/refined_landmarks.json");
const NOSE_TIP = 4;
const NOSE_MM = 5;

test.use({ visit: { scripts: [watchCamera, watchFrames] } });

test("in the mirror the film is seen with its sides swapped, and with the edits where the face is", { tag: "@seen-camera" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.slide("nose-width", NOSE_MM);
  await openMirror(visitor);
  assert.ok((await figures(visitor)).frames > 0);

  const nose = await nosePlace();
  for (let time = 0; time < 3; time += 1) {
    await visitor.frames(30);
    await setFrozen(visitor, true);
    const now = await filmOf(visitor);
    await page.focus("#viewport");
    await page.keyboard.down("b");
    const unedited = await filmOf(visitor);
    await page.keyboard.up("b");
    await setFrozen(visitor, false);

    // The ground of the film is the redder the further to the right.
    const [left] = meanColour(now, { left: 0.02, right: 0.1, top: 0.1, bottom: 0.3 });
    const [right] = meanColour(now, { left: 0.9, right: 0.98, top: 0.1, bottom: 0.3 });
    assert.ok(right > left + 100, `turned back, the film is the right way round: ${left}, ${right}`);

    const number = numberOf(unedited);
    const [x, y] = carried(placeIn(number), nose);
    assert.ok(differenceNear(now, unedited, { x, y }, 24) > 0.1, "the nose is another");
    for (const [cx, cy] of [[40, 40], [600, 40], [40, 400], [600, 440]]) {
      assert.equal(differenceNear(now, unedited, { x: cx, y: cy }, 24), 0, "the film's corners are the same");
    }
    const off_px = middleOfChange(now, unedited).x - x;
    const [speed_px_s, most_ms] = [200, 60];
    assert.ok(Math.abs(off_px) < (speed_px_s * most_ms) / 1000, `in frame ${number} the edit is ${off_px} px beside the nose`);
  }
  await page.click("#live-close");
  assert.equal((await camera(visitor)).live, 0);
});

test("what is seen in the mirror is kept as a photo with its edits, and the camera stops", { tag: ["@moving-camera", "@rare"] }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.slide("nose-width", NOSE_MM);
  await openMirror(visitor);
  // An edit that is made in the mirror is kept as well.
  await visitor.slide("eye-size", 2);
  await page.click("#live-keep");
  await page.waitForSelector("#live", { state: "hidden" });
  await page.waitForSelector("#previous-face:visible");
  await visitor.untilFace();
  assert.equal((await visitor.history()).length, 2);
  assert.equal(await visitor.sliderValue("nose-width"), NOSE_MM);
  assert.equal(await visitor.sliderValue("eye-size"), 2);
  assert.deepEqual(await camera(visitor), { asked: 1, tracks: 1, live: 0 });
});

test("without a face open, the first one that the camera sees is opened; a double click opens one camera", { tag: ["@moving-camera", "@rare"] }, async ({ open }) => {
  const visitor = await open({ viewport: { width: 390, height: 844 } });
  const { page } = visitor;
  await visitor.untilLoaded();
  await page.dblclick("#welcome [data-action='mirror']");
  await visitor.untilFace();
  await untilShown(visitor);
  assert.equal(await page.getAttribute("body", "data-scene"), "picture");
  // It rests for a part of the film.
  await expect(async () => {
    const { age, interval_ms, jitter_px } = await figures(visitor);
    assert.ok(age <= 1 + (2 * interval_ms * FRAMES_PER_S) / 1000, `${age} frames old, every ${interval_ms} ms`);
    assert.ok(jitter_px < 0.3, `it trembles by ${jitter_px} px`);
  }).toPass({ timeout: 30_000, intervals: [200] });
  assert.deepEqual(await findings(page), [], "on a phone nothing is cut and nothing overlaps");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#live", { state: "hidden" });
  assert.equal(await page.getAttribute("body", "data-state"), "face");
  assert.deepEqual(await camera(visitor), { asked: 1, tracks: 1, live: 0 });
  assert.equal(await page.getAttribute("#privacy-count", "data-requests"), "0", "nothing was sent");
});

test("in the mirror a face is lost and found, a worker that dies is said, and a hidden page has no camera", { tag: ["@moving-camera", "@rare"] }, async ({ open }) => {
  const visitor = await open({ scripts: [watchCamera, watchFrames, trapWorkers] });
  const { page } = visitor;
  await visitor.dropSample();
  await openMirror(visitor);
  await page.evaluate(() => (window.isBlank = true));
  await page.waitForFunction(() => document.getElementById("live-status").textContent === "No face in sight");
  assert.ok(await page.isDisabled("#live-keep"));
  await page.evaluate(() => (window.isBlank = false));
  await page.waitForSelector("#live-keep:enabled");

  await page.evaluate(() => (window.visionDies = true));
  assert.equal((await visitor.notice()).code, "worker-died");
  await page.waitForSelector("#live-keep:enabled");

  await show(visitor, "hidden");
  await page.waitForFunction(() => window.cameraTracks.every(({ readyState }) => readyState === "ended"));
  await show(visitor, "visible");
  await page.waitForSelector("#live-keep:enabled");
  assert.deepEqual(await camera(visitor), { asked: 2, tracks: 2, live: 1 });

  // The other camera takes its place.
  await visitor.unfold("section-photo");
  await page.click("#section-photo [data-action='camera']");
  await page.waitForSelector("#camera-shutter:enabled");
  assert.ok(await page.isHidden("#live"));
  assert.equal((await camera(visitor)).live, 1);
});

test("a camera that is refused or unplugged ends the mirror, and says why", { tag: "@moving-camera" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();
  await page.evaluate(() => (window.isRefused = true));
  await page.click("#welcome [data-action='mirror']");
  assert.equal((await visitor.notice()).code, "camera-refused");
  assert.ok(await page.isHidden("#live"));
  await page.evaluate(() => (window.isRefused = false));
  await visitor.dropSample();
  await openMirror(visitor);
  await page.evaluate(() => window.unplugCamera());
  assert.equal((await visitor.notice()).code, "camera-lost");
  assert.ok(await page.isHidden("#live"));
  assert.equal((await camera(visitor)).live, 0);
  // The photo is there again, and is turned as before.
  await page.waitForFunction(() => document.body.dataset.scene === "solid");
});

/** Opens the mirror over the face that is open, and waits until the stage shows it. @param {Visitor} visitor */
async function openMirror(visitor) {
  await visitor.unfold("section-photo");
  await visitor.page.click("#section-photo [data-action='mirror']");
  await untilShown(visitor);
}

/** @param {Visitor} visitor */
async function untilShown(visitor) {
  await visitor.page.waitForSelector("#live-keep:enabled");
  await visitor.page.waitForSelector("#live-video", { state: "hidden" });
  if (!(await visitor.page.isVisible("#live-figures"))) await visitor.page.click("#live-figures-shown");
  await visitor.page.waitForSelector("#live-figures[data-frames]:not(:empty)");
}

/** @param {Visitor} visitor */
async function figures({ page }) {
  const found = await page.locator("#live-figures").evaluate(({ dataset }) => ({ ...dataset }));
  return Object.fromEntries(Object.entries(found).map(([name, value]) => [name, Number(value)]));
}

/** No frame more comes, and what was on its way is there. @param {Visitor} visitor @param {boolean} isFrozen */
async function setFrozen({ page }, isFrozen) {
  await page.evaluate((isFrozen) => (window.isFrozen = isFrozen), isFrozen);
  if (isFrozen) await page.waitForFunction(() => window.following === 0);
}

/** The film as the stage shows it, turned back and as large as it came. @param {Visitor} visitor */
async function filmOf(visitor) {
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

/** @typedef {import("./pixels.mjs").Pixels} Pixels */

/** @param {Pixels} a @param {Pixels} b */
function middleOfChange(a, b) {
  const sum = { x: 0, y: 0, weight: 0 };
  for (let at = 0; at < a.data.length; at += 4) {
    const weight = [0, 1, 2].reduce((most, channel) => Math.max(most, Math.abs(a.data[at + channel] - b.data[at + channel])), 0);
    sum.x += weight * ((at / 4) % a.width);
    sum.y += weight * Math.floor(at / 4 / a.width);
    sum.weight += weight;
  }
  return { x: sum.x / sum.weight, y: sum.y / sum.weight };
}

/** In the portrait, px. */
async function nosePlace() {
  const [face] = JSON.parse(await readFile(GOLDEN, "utf8")).portrait.faces;
  return [face[3 * NOSE_TIP] / 1000, face[3 * NOSE_TIP + 1] / 1000];
}

/** As the browser does when another tab comes before this one. @param {Visitor} visitor @param {string} state */
function show({ page }, state) {
  return page.evaluate((state) => {
    Object.defineProperty(document, "visibilityState", { configurable: true, get: () => state });
    document.dispatchEvent(new Event("visibilitychange"));
  }, state);
}

/** Runs in the page before its own scripts: frames that never come, frames of nothing, and how many the worker has not answered. */
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
    const hear = ({ data }) => {
      if (data.id !== message.id) return;
      window.following -= 1;
      this.removeEventListener("message", hear);
    };
    this.addEventListener("message", hear);
  };
}

/** Runs in the page before its own scripts, too. */
function trapWorkers() {
  const Original = Worker;
  window.Worker = class extends Original {
    postMessage(message, transfer) {
      super.postMessage(message, transfer);
      if (!window.visionDies || message.type !== "follow") return;
      window.visionDies = false;
      // As a trap does: the worker says so, and is of no more use.
      this.dispatchEvent(new MessageEvent("message", { data: { type: "trapped", id: message.id, message: "unreachable" } }));
    }
  };
}
