import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test("hints stay until followed, a dot marks the point to drag, and returning users see neither", { tag: "@rare" }, async ({ visitor, page }) => {
  const hint = async () => ((await page.isVisible("#hint")) ? page.textContent("#hint") : "");
  await visitor.dropSample();
  assert.equal(await hint(), "Drag the nose");
  const [dot, tip] = [await page.locator("#pulse").boundingBox(), await visitor.landmarkPosition(1)];
  const off_px = Math.hypot(dot.x + dot.width / 2 - tip.x, dot.y + dot.height / 2 - tip.y);
  assert.ok(off_px < 2, `the dot is ${off_px} px from the nose`);
  const beside = await visitor.emptyPoint();
  await page.mouse.click(beside.x, beside.y);
  assert.equal(await hint(), "Drag the nose", "a click does not complete the hint");
  await visitor.drag(tip, { x: 0, y: -20 });
  assert.ok(await page.isHidden("#pulse"));
  assert.equal(await hint(), "Drag outside the face to turn it");
  await visitor.drag(beside, { x: 30, y: 0 });
  assert.equal(await hint(), "");
  await visitor.dropSample();
  assert.equal(await hint(), "", "a hint was repeated");
  await page.reload();
  await visitor.dropSample();
  assert.equal(await hint(), "", "a completed hint was shown after a reload");
});

test("on touch devices the hint mentions fingers", { tag: "@rare" }, async ({ open }) => {
  const visitor = await open({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  const { page } = visitor;
  await visitor.dropSample();
  const tip = await visitor.landmarkPosition(1);
  const touch = await page.context().newCDPSession(page);
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [tip] });
  for (const up of [10, 20]) await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: tip.x, y: tip.y - up }] });
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.match(await page.innerText("#hint"), /two fingers/);
});

test("a new face swings briefly, except with reduced motion", { tag: "@rare" }, async ({ open }) => {
  for (const reducedMotion of /** @type {const} */ (["no-preference", "reduce"])) {
    const visitor = await open({ reducedMotion });
    const { page } = visitor;
    await visitor.untilLoaded();
    await page.evaluate(() => {
      const places_px = [];
      globalThis.swing = () => Math.max(...places_px) - Math.min(...places_px);
      const look = () => {
        const x_px = Number.parseFloat(document.getElementById("pulse").style.translate);
        if (Number.isFinite(x_px)) places_px.push(x_px);
        requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
    await visitor.dropSample();
    if (reducedMotion === "no-preference") await page.waitForFunction(() => globalThis.swing() > 15);
    await page.waitForFunction(() => {
      const [pulse, view] = ["pulse", "viewport"].map((id) => document.getElementById(id).getBoundingClientRect());
      return Math.abs(pulse.x + pulse.width / 2 - view.x - view.width / 2) < 12;
    });
    await visitor.frames(30);
    const swing_px = await page.evaluate("swing()");
    assert.equal(swing_px > 15, reducedMotion === "no-preference", `${reducedMotion}: the nose swings by ${swing_px} px`);
    await visitor.leave();
  }
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
