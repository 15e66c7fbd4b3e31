// The 3D printing panel: size, warnings, and the body on the stage.
import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

/** Size of a binary STL in mm. @param {Buffer} stl */
function sizeOf(stl) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (let at = 84; at < stl.length; at += 50) {
    for (let number = 3; number < 12; number += 1) {
      const [axis, value] = [number % 3, stl.readFloatLE(at + 4 * number)];
      [low[axis], high[axis]] = [Math.min(low[axis], value), Math.max(high[axis], value)];
    }
  }
  return high.map((end, axis) => end - low[axis]);
}

test("a print of 80 mm is shown on the stage, with a note where a wall of 2 mm does not fit", { tag: "@eyes" }, async ({ editor, page }) => {
  const pixels = async () => (await editor.view()).data;
  const face = await pixels();
  await editor.reveal("#print-facts");
  await page.waitForSelector("#print-facts:not([data-stale]) dd");
  await expect(page.locator("input[name='print-height'][value='80']")).toBeChecked();
  const [, height] = sizeOf(await editor.download("download-stl"));
  assert.ok(Math.abs(height - 80) < 2, `${height} mm high`);
  await expect(page.locator("#print-thin")).toHaveText(/^2\.0 mm asked, thinnest [\d.]+ mm: /);
  assert.equal(await page.getAttribute("#print-thin", "data-tone"), "warning");
  await expect(page.locator("#print-supports")).toHaveText(/^Print it (lying on its back|upright)/);

  const body = await pixels();
  assert.ok(!body.equals(face), "the stage shows the face");
  await page.click("#print-behind");
  await expect.poll(async () => (await pixels()).equals(body)).toBe(false);

  await page.click("#print > summary");
  await page.click("#toolbar [data-action='reset-view']");
  await expect.poll(async () => (await pixels()).equals(face)).toBe(true);
});

test("a relief needs no supports, and its depth and height are those chosen", async ({ editor, page }) => {
  await editor.reveal("#print-facts");
  await page.check("input[name='solid'][value='flat']", { force: true });
  await page.check("input[name='print-height'][value='40']", { force: true });
  await page.fill("#solid-flat-mm .number-field", "12");
  const [, height, depth] = sizeOf(await editor.download("download-stl"));
  assert.ok(Math.abs(height - 40) < 1 && Math.abs(depth - 12) < 0.01, `${height} × ${depth} mm`);
  await expect(page.locator("#print-supports")).toHaveText("Print it lying on its back, without supports.");
  await expect(page.locator("#print-thin")).toBeHidden();
});
