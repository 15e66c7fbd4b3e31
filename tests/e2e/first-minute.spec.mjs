import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test("hints invite to turn and to drag, until the first edit", async ({ visitor, page }) => {
  const hint = async () => ((await page.isVisible("#hint")) ? page.textContent("#hint") : "");
  await visitor.dropSample();
  assert.equal(await hint(), "Drag next to the face to turn it");
  const beside = await visitor.emptyPoint();
  await page.mouse.click(beside.x, beside.y);
  assert.equal(await hint(), "Drag next to the face to turn it", "a click does not complete the hint");
  await visitor.drag(beside, { x: 30, y: 0 });
  assert.equal(await hint(), "Drag the nose, or move a slider");
  await page.click("#tab-export");
  assert.equal(await hint(), "", "the hint is in the way of the export");
  await page.click("#tab-shape");
  await visitor.setSlider("nose-width", 1);
  assert.equal(await hint(), "");
  await visitor.dropSample();
  assert.equal(await hint(), "", "a hint was repeated");
  await page.reload();
  await visitor.dropSample();
  assert.equal(await hint(), "", "a completed hint was shown after a reload");
});

test("on touch devices the hint mentions fingers", async ({ open }) => {
  const visitor = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await visitor.dropSample();
  assert.match(await visitor.page.innerText("#hint"), /two fingers/);
});

test("one second after a drag, nothing covers the face", async ({ editor, page }) => {
  const nose = await editor.landmarkPosition(1);
  const opacity = () => page.locator("#landmark-tag").evaluate((tag) => Number(getComputedStyle(tag).opacity));
  await editor.grab(nose, { x: 4, y: -12 });
  // More than a second, after which the name of a released point disappears.
  await editor.frames(80);
  assert.equal(await opacity(), 1, "the name disappears during the drag");
  await page.mouse.up();
  assert.equal(await opacity(), 1);
  await expect.poll(opacity, { timeout: 3000 }).toBe(0);
  await page.mouse.move(nose.x + 1, nose.y);
  await expect.poll(opacity).toBe(1);
});

test("a pointer that rests on the face does not keep the page drawing", async ({ editor, page }) => {
  const nose = await editor.landmarkPosition(1);
  await page.evaluate(() => {
    const { submit } = GPUQueue.prototype;
    globalThis.submissions = 0;
    GPUQueue.prototype.submit = function (...commands) {
      globalThis.submissions += 1;
      return submit.apply(this, commands);
    };
  });
  await page.mouse.move(nose.x, nose.y);
  // The marks are displayed for a second.
  await editor.frames(60);
  const count = await page.evaluate("submissions");
  assert.ok(count > 0 && count < 8, `${count} frames`);
});

for (const [drawn, needs] of /** @type {const} */ ([["WebGPU", "eyes"], ["WebGL2", "webgl"]])) {
  test(`before a photo opens, only the wireframe covers the background: ${drawn}`, { tag: `@${needs}` }, async ({ open }) => {
    const visitor = await open({ colorScheme: "light", reducedMotion: "reduce" });
    await visitor.untilLoaded();
    const { data, width, height } = await visitor.view();
    const nearGround = (/** @type {number} */ at) => [0xf5, 0xf3, 0xef].every((ground, channel) => Math.abs(data[at + channel] - ground) < 24);
    const isGround = Array.from({ length: width * height }, (_, pixel) => nearGround(4 * pixel));
    assert.ok(isGround[0] && isGround[width - 1], `the corner is ${data.subarray(0, 4)}`);
    const share = isGround.filter(Boolean).length / isGround.length;
    assert.ok(share > 0.7 && share < 0.999, `${share} of the view is ground`);
  });
}

for (const [reducedMotion, moves] of /** @type {const} */ ([["no-preference", true], ["reduce", false]])) {
  const verb = moves ? "turns slowly" : "keeps still";
  test(`with ${reducedMotion} for motion, the empty face ${verb}`, { tag: "@eyes" }, async ({ open }) => {
    const visitor = await open({ reducedMotion });
    await visitor.untilLoaded();
    const shot = async () => PNG.sync.read(await visitor.page.locator("#viewport").screenshot());
    const first = await shot();
    await visitor.frames(30);
    assert.equal(difference(first, await shot()) > 0, moves);
    const durations = await visitor.page.locator("*").evaluateAll((all) => all.map((one) => getComputedStyle(one).transitionDuration));
    const longest_ms = Math.max(...durations.flatMap((each) => each.split(",")).map((duration) => 1000 * Number.parseFloat(duration)));
    assert.ok(moves ? longest_ms >= 100 : longest_ms === 0, `a transition of ${longest_ms} ms`);
  });
}
