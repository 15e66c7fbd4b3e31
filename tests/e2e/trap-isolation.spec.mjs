import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { untilSaved } from "./storage.mjs";
import { hookModule, trapIn } from "./page-scripts.mjs";

test.use({ visit: { scripts: [hookModule] } });

test("after a trap no code calls into the instance, and the next one gets the work", async ({ editor, page }) => {
  await editor.untilLoaded();
  await editor.move("nose tip", "z", 9);
  await editor.meshJson("mm");
  const project = await editor.download("save-project");
  await untilSaved(page);

  const before = await page.evaluate("hooked.calls[0]");
  assert.ok(before > 100, `${before} calls were counted`);
  await page.evaluate(trapIn, "studio_apply");
  await page.focus("#viewport");
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => globalThis.hooked.calls.length === 2);
  const calls = await page.evaluate("hooked.calls[0]");
  await pressEverything(editor);
  await expect.poll(() => page.evaluate("hooked.calls[1]")).toBeGreaterThan(50);
  await editor.drop(project, "face.rosto");
  await editor.untilFace();
  await pressEverything(editor);
  // Collects wrappers of the trapped instance's objects.
  await page.requestGC();
  await editor.frames(5);
  assert.equal(await page.evaluate("hooked.calls[0]"), calls, "the trapped instance was called later");
});

/** Uses the page's controls and drags on the face. */
async function pressEverything(editor) {
  const { page } = editor;
  const { x, y, width, height } = await page.locator("#viewport").boundingBox();
  await editor.drag({ x: x + width / 2, y: y + height / 2 }, { x: 20, y: 10 });
  await page.mouse.wheel(0, 40);
  await page.evaluate(() => {
    const inputs = [...document.querySelectorAll("#panel input, #panel select, #toolbar input")].filter(({ type }) => type !== "file");
    for (const input of inputs) for (const type of ["input", "change"]) input.dispatchEvent(new Event(type, { bubbles: true }));
    for (const details of document.querySelectorAll("#panel details")) details.open = !details.open;
    const skipped = "#photo-change, #add-photo, #clip, [data-action='choose'], [data-action='sample']";
    for (const button of document.querySelectorAll(`:is(#panel, #toolbar) button:not(${skipped})`)) button.click();
    for (const key of ["z", "ArrowUp", "Escape"]) {
      const press = new KeyboardEvent("keydown", { key, ctrlKey: key === "z", bubbles: true, cancelable: true });
      document.getElementById("viewport").dispatchEvent(press);
    }
  });
  await editor.frames(5);
}
