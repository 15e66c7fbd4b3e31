import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { viewport: { width: 1024, height: 480 }, hasClock: true } });

test("after opening another photo, no control keeps a selection, input or scroll position", async ({ editor, page }) => {
  await editor.untilLoaded();
  const photo = await asJpeg(page, await readFile(SAMPLE));
  const fresh = await controls(page);

  await editor.selectRegion("left-brow");
  await editor.setOffset("y", 3);
  await editor.unfold("symmetrise");
  await page.fill("#symmetrise .number-field", "80");
  await editor.unfold("section-export");
  await page.click("[data-action='check-glb']");
  await page.waitForSelector("#verdict[data-tone='success']");
  // Typed, but not committed.
  await editor.unfold("slider-nose-width");
  await page.locator("#slider-nose-width .number-field").fill("7");
  await page.evaluate(() => (document.getElementById("sections").scrollTop = 400));
  assert.notDeepEqual(await controls(page), fresh);

  await editor.drop(photo, "new.jpg");
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 0);
  await editor.frames(5);
  assert.deepEqual(await controls(page), { ...fresh, tab: "shape", chosenTab: "tab-shape", scroll: 0, verdict: "" });
  assert.ok(await page.isHidden("#verdict"), "the verdict is of another file");

  // Unfinished input of the previous face is not committed later.
  await editor.unfold("symmetrise");
  await page.locator("#symmetrise .number-field").focus();
  await page.clock.runFor(1000);
  assert.deepEqual(await editor.history(), []);
  assert.equal(await editor.sliderValue("nose-width"), 0);
});

test("a pending search is cleared when another face opens", async ({ editor, page }) => {
  await editor.selectBy("landmark");
  await page.fill("#landmark-search", "no such place");
  await page.press("#landmark-search", "Enter");
  await expect(page.locator("#landmark-search-error")).toBeVisible();
  await page.fill("#landmark-search", "the ear");
  await editor.drop(await asJpeg(page, await readFile(SAMPLE)), "new.jpg");
  await page.waitForFunction(() => document.getElementById("landmark-search").value === "");
  await editor.untilFace();
  await expect(page.locator("#landmark-search-error")).toBeHidden();
  assert.ok(!(await page.locator("#landmark-search").evaluate((field) => field.hasAttribute("aria-invalid"))));
  assert.ok(await page.isHidden("#notice"));
});

/** The panel's controls that depend on the face. */
function controls(page) {
  return page.evaluate(() => {
    const value = (id) => document.getElementById(id).value;
    return {
      tab: document.body.dataset.tab,
      chosenTab: document.querySelector("[role=tab][aria-selected=true]").id,
      scroll: document.getElementById("sections").scrollTop,
      region: value("region"),
      search: value("landmark-search"),
      share: document.querySelector("#symmetrise .number-field").value,
      numbers: [...document.querySelectorAll("#section-face [id^='slider-'] input, #landmark-offset input")].map((input) => input.value),
      verdict: document.getElementById("verdict").innerText,
      entries: document.querySelectorAll("#history .check").length,
    };
  });
}
