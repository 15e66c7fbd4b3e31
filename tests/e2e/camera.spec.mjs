import assert from "node:assert/strict";
import { camera, recordCamera, rejectIn } from "./camera-watch.mjs";
import { variants, test } from "./fixtures.mjs";

/** Records the page's requests for the camera. */
test.use({ visit: { scripts: [recordCamera] } });

/** Longer than the countdown. */
const COUNTED_MS = 5000;

for (const [[presses, press], tag] of variants([
  ["a double click opens", ({ page }) => page.dblclick("#welcome [data-action='camera']")],
  ["two clicks in one task open", pressTwice],
])) {
  test(`${presses} one camera; Escape or the button stops it`, { tag: [...tag, "@camera"] }, async ({ visitor, page }) => {
    await press(visitor);
    await page.waitForSelector("#camera-shutter:enabled");
    await leaveCamera(page);
    assert.deepEqual(await camera(visitor), { asked: 1, tracks: 1, live: 0 });

    await openCamera(page);
    assert.equal((await camera(visitor)).live, 1);
    await page.click("#camera [data-action='close-camera']");
    assert.deepEqual(await camera(visitor), { asked: 2, tracks: 2, live: 0 });
  });
}

test("the dialog opens while the browser prompts, and a camera allowed after closing stops immediately", { tag: "@camera" }, async ({ visitor, page }) => {
  await page.evaluate(() => (window.cameraWaits = true));
  await page.click("#welcome [data-action='camera']");
  assert.match(await page.innerText("#camera-status"), /allow the camera/);
  assert.ok(await page.isDisabled("#camera-shutter"));
  await leaveCamera(page);
  await page.evaluate(() => window.allowCamera());
  await page.waitForFunction(() => window.cameraTracks.length === 1 && window.cameraTracks[0].readyState === "ended");

  // Closed and reopened during the prompt: its one answer serves the open dialog.
  await page.click("#welcome [data-action='camera']");
  await leaveCamera(page);
  await page.click("#welcome [data-action='camera']");
  await page.evaluate(() => window.allowCamera());
  await page.waitForSelector("#camera-shutter:enabled");
  assert.deepEqual(await camera(visitor), { asked: 2, tracks: 2, live: 1 });
  await leaveCamera(page);
  assert.equal((await camera(visitor)).live, 0);
});

for (const moment of ["before the photo", "during the countdown"]) {
  test(`a camera unplugged ${moment} closes the dialog with a notice and takes no photo`, { tag: "@camera" }, async ({ open }) => {
    const visitor = await open({ hasClock: true });
    const { page } = visitor;
    await openCamera(page);
    if (moment === "during the countdown") await page.click("#camera-shutter");
    await page.evaluate(() => window.unplugCamera());
    assert.equal((await visitor.notice()).code, "camera-lost");
    assert.ok(await page.isHidden("#camera"));
    await page.clock.runFor(COUNTED_MS);
    await visitor.frames(10);
    assert.equal(await page.getAttribute("#notice", "data-code"), "camera-lost");
    assert.equal(await page.getAttribute("body", "data-state"), "empty");
    assert.equal((await camera(visitor)).live, 0);
  });
}

test("Escape during the countdown takes no photo", { tag: "@camera" }, async ({ open }) => {
  const visitor = await open({ hasClock: true });
  const { page } = visitor;
  await openCamera(page);
  await page.click("#camera-shutter");
  await page.waitForFunction(() => /[123]/.test(document.getElementById("camera-countdown").textContent));
  await leaveCamera(page);
  // The first countdown must not take a photo in the reopened dialog.
  await page.click("#welcome [data-action='camera']");
  await page.clock.runFor(COUNTED_MS);
  await visitor.frames(10);
  assert.ok(await page.isVisible("#camera"));
  assert.equal(await page.innerText("#camera-countdown"), "");
  assert.equal(await page.getAttribute("body", "data-state"), "empty");
  assert.ok(await page.isHidden("#progress"));
});

test("no photo is taken of a video without a size", { tag: "@camera" }, async ({ open }) => {
  const hideSize = () => Object.defineProperty(HTMLVideoElement.prototype, "videoWidth", { get: () => (window.videoHasSize ? 512 : 0) });
  const visitor = await open({ scripts: [recordCamera, hideSize] });
  const { page } = visitor;
  await page.click("#welcome [data-action='camera']");
  await page.waitForFunction(() => document.getElementById("camera-preview").readyState >= HTMLMediaElement.HAVE_FUTURE_DATA);
  await visitor.frames(10);
  assert.ok(await page.isDisabled("#camera-shutter"));
  await page.evaluate(() => {
    window.videoHasSize = true;
    document.getElementById("camera-preview").dispatchEvent(new Event("resize"));
  });
  await page.waitForSelector("#camera-shutter:enabled");
});

test("a camera closed while it starts, or that cannot play or be photographed, leaves no unhandled rejection", { tag: "@camera" }, async ({ visitor, page }) => {
  for (let time = 0; time < 3; time += 1) {
    await page.click("#welcome [data-action='camera']");
    await leaveCamera(page);
  }
  // Closed in the task in which the video starts to play.
  await page.evaluate(() => {
    const { play } = HTMLMediaElement.prototype;
    HTMLMediaElement.prototype.play = function () {
      HTMLMediaElement.prototype.play = play;
      const playing = this.play();
      document.querySelector("[data-action='close-camera']").click();
      return playing;
    };
  });
  await page.click("#welcome [data-action='camera']");
  await page.waitForSelector("#camera", { state: "hidden" });
  assert.ok(await page.isHidden("#notice"));

  await openCamera(page);
  await page.evaluate(rejectIn, ["OffscreenCanvas", "convertToBlob"]);
  await page.click("#camera-shutter");
  assert.equal((await visitor.notice()).code, "other");
  assert.ok(await page.isHidden("#camera"));

  await openCamera(page);
  await page.evaluate(() => (window.createImageBitmap = () => Promise.reject(new DOMException("not usable", "InvalidStateError"))));
  await page.click("#camera-shutter");
  await page.waitForSelector("#notice[data-code='camera-lost']");
  assert.ok(await page.isHidden("#camera"));

  await page.evaluate(rejectIn, ["HTMLMediaElement", "play"]);
  await page.click("#welcome [data-action='camera']");
  await page.waitForSelector("#notice[data-code='no-camera']");
  assert.ok(await page.isHidden("#camera"));
  assert.equal((await camera(visitor)).live, 0);
  assert.deepEqual(await page.evaluate(() => window.rejections), []);
});

/** Opens the camera and waits until it can take a photo. @param {import("@playwright/test").Page} page */
async function openCamera(page) {
  await page.click("#welcome [data-action='camera']");
  await page.waitForSelector("#camera-shutter:enabled");
}

/** Closes the dialog with Escape and waits until the camera has stopped, which the page learns slightly later. */
async function leaveCamera(page) {
  await page.keyboard.press("Escape");
  await page.waitForSelector("#camera", { state: "hidden" });
  await page.waitForFunction(() => window.cameraTracks.every((track) => track.readyState === "ended"), undefined, { timeout: 5000 });
}

/** Clicks by script do not wait for the page, so load it first. @param {import("./visitor.mjs").Visitor} visitor */
async function pressTwice(visitor) {
  await visitor.untilLoaded();
  await visitor.page.locator("#welcome [data-action='camera']").evaluate((button) => {
    button.click();
    button.click();
  });
}
