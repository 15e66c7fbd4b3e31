import assert from "node:assert/strict";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh, displacement } from "./meshes.mjs";
import { PAGE_OPTIONS } from "./same-face.mjs";
import { SAMPLE } from "./visitor.mjs";

/** The alae of the nose, right and left. */
const WINGS = [64, 294];

test("nose width moves both sides equally, is one entry, equals the command line's result, and resets by a double click", { tag: "@usual" }, async ({ editor, page }) => {
  assert.equal(await page.locator("#section-face [id^='slider-']").count(), 10);
  const before = await editor.meshJson("mm");

  await editor.unfold("slider-nose-width");
  const track = page.locator("#slider-nose-width input[type=range]");
  await track.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await track.boundingBox();
  await editor.drag({ x: x + width / 2, y: y + height / 2 }, { x: 0.3 * width, y: 0 });
  const amount_mm = await editor.sliderValue("nose-width");
  assert.ok(amount_mm > 2, `the slider is at ${amount_mm}`);
  assert.deepEqual(await editor.history(), ["Nose width"]);

  const after = await editor.meshJson("mm");
  const [right, left] = WINGS.map((wing) => displacement(before, after, wing));
  assert.ok(Math.abs(left[0] - amount_mm) < 1e-6 && Math.abs(left[0] + right[0]) < 1e-6, `${right}, ${left}`);
  assertSameMesh(after, await meshByCommandLine(SAMPLE, [...PAGE_OPTIONS, "--slider", `nose-width:${amount_mm}`]));

  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), before);
  assert.equal(await editor.sliderValue("nose-width"), 0);
  await page.click("#toolbar [data-action='redo']");
  assert.deepEqual(await editor.meshJson("mm"), after);
  assert.equal(await editor.sliderValue("nose-width"), amount_mm);
  await editor.unfold("slider-nose-width");
  await page.dblclick("#slider-nose-width .slider-label");
  assert.equal(await editor.sliderValue("nose-width"), 0);
});

test("sliders work by keyboard and in Portuguese, and keep the selected landmark", async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  await page.selectOption("#language", "pt");
  assert.equal(await page.innerText("#slider-jaw-width .slider-label"), "Largura da mandíbula");
  await editor.unfold("slider-jaw-width");
  await page.focus("#slider-jaw-width input[type=range]");
  for (let press = 0; press < 5; press++) await page.keyboard.press("ArrowRight");
  await page.waitForSelector("#history .check", { state: "attached" });
  assert.deepEqual(await editor.history(), ["Largura da mandíbula"]);
  assert.match(await page.innerText("#announcement"), /Largura da mandíbula: 0,5 milímetros/);
  assert.equal(await editor.sliderValue("jaw-width"), 0.5);
  await editor.setOffset("z", 4);
  assert.equal((await editor.history()).length, 2);
  assert.equal(await editor.selectedLandmark(), 1);
});
