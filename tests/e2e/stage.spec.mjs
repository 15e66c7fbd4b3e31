import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

test("the canvas has the device's pixels also after the pixel ratio changes", { tag: "@usual" }, async ({ editor, page }) => {
  const chrome = await page.context().newCDPSession(page);
  const { width, height } = page.viewportSize();
  const start = await editor.landmarkPosition(1);
  for (const ratio of [2, 1.5, 1]) {
    await chrome.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: ratio, mobile: false });
    await page.waitForFunction((ratio) => {
      const canvas = document.getElementById("viewport");
      return Math.abs(canvas.width - ratio * canvas.clientWidth) <= 1 && Math.abs(canvas.height - ratio * canvas.clientHeight) <= 1;
    }, ratio);
    const nose = await editor.landmarkPosition(1);
    const moved_px = Math.hypot(nose.x - start.x, nose.y - start.y);
    assert.ok(moved_px < 2, `at ${ratio}, the face has moved by ${moved_px} px`);
  }
});

test("a click selects the point that is named under the pointer", async ({ editor, page }) => {
  await editor.enableExpert();
  const tip = await editor.landmarkPosition(1);
  for (const [dx, dy] of [[0, 0], [5, 4], [12, 3], [-7, 6], [-15, -18], [4, 22], [8, 8]]) {
    await page.mouse.move(tip.x + dx, tip.y + dy);
    await editor.frames(2);
    const named = await page.innerText("#landmark-tag");
    await page.mouse.down();
    await page.mouse.up();
    const number = /\d+$/.exec(named)?.[0];
    assert.equal(await editor.selectedLandmark(), Number(number), `${named} at ${dx}, ${dy}`);
  }
});

test("no shortcut works in a list, in a text, or while a word is composed", async ({ editor, page }) => {
  await editor.setSlider("nose-width", 3);
  const before = await editor.history();
  const scene = () => page.evaluate(() => document.body.dataset.scene);
  const start = await scene();
  await page.evaluate(() => {
    const parts = [document.createElement("textarea"), document.createElement("input"), document.createElement("select"), document.createElement("p")];
    parts[3].contentEditable = "true";
    for (const [index, part] of parts.entries()) part.id = `typing-${index}`;
    document.body.prepend(...parts);
  });
  for (let index = 0; index < 4; index++) {
    await page.focus(`#typing-${index}`);
    for (const key of ["p", "f", "w"]) await page.keyboard.press(key);
    if (index !== 2) await page.keyboard.press("Control+z");
    assert.deepEqual([await scene(), await editor.history()], [start, before], `element ${index}`);
  }
  await page.evaluate(() => {
    for (let index = 0; index < 4; index++) document.getElementById(`typing-${index}`).remove();
  });
  await page.focus("#viewport");
  await page.evaluate(() => {
    for (const key of ["p", "z", "b"]) {
      // Browsers mark the first key of a word by its code only.
      for (const mark of [{ isComposing: true }, { keyCode: 229 }]) {
        const event = new KeyboardEvent("keydown", { key, ctrlKey: key === "z", bubbles: true, ...mark });
        document.activeElement.dispatchEvent(event);
      }
    }
  });
  assert.deepEqual([await scene(), await editor.history()], [start, before], "while composing");
  assert.equal(await page.evaluate(() => document.body.hasAttribute("data-comparing")), false, "B works while composing");
  await page.keyboard.press("p");
  assert.notEqual(await scene(), start);
  await page.keyboard.press("Control+z");
  assert.deepEqual(await editor.history(), []);
});
