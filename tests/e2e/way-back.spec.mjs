import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { keptWorks, untilKept } from "./kept.mjs";

test("a page that is gone back to goes on with its work", { tag: "@way-back" }, async ({ editor, page }) => {
  await leave(editor);
  assert.ok(await goBack(page), "the browser did not keep the page");
  await expect.poll(async () => (await keptWorks(page)).filter(({ isHeld }) => isHeld).length).toBe(1);
  await editor.offset("y", 4);
  const work = await editor.work();
  await untilKept(page);
  assert.deepEqual((await keptWorks(page)).map(({ isHeld }) => isHeld), [true]);
  await editor.comeBack();
  assert.deepEqual(await editor.work(), work);
});

for (const [how, stays] of /** @type {const} */ ([["is open in", true], ["went on in", false]])) {
  test(`a page that is gone back to leaves alone the work that ${how} another tab`, { tag: "@way-back" }, async ({ editor, page }) => {
    await leave(editor);
    const other = await editor.anotherTab();
    await other.resume();
    await other.move("bottom of the chin", "y", -6);
    const others = await other.work();
    await untilKept(other.page);
    if (!stays) await other.page.close();

    await page.bringToFront();
    let work;
    if (await goBack(page)) {
      // What is edited here now is kept beside the work that was continued elsewhere.
      await untilKept(page, 2);
      await editor.offset("y", 4);
      work = await editor.work();
      await untilKept(page);
      assert.equal((await keptWorks(page)).length, 2);
    }
    if (stays) {
      await other.page.bringToFront();
      await other.page.reload();
    }
    const next = stays ? other : await editor.anotherTab();
    await next.resume();
    assert.deepEqual(await next.work(), others);
    if (work) {
      await page.bringToFront();
      await editor.comeBack();
      assert.deepEqual(await editor.work(), work);
    }
  });
}

/** Edits the face and follows a link to somewhere else. */
async function leave(editor) {
  const { page } = editor;
  await editor.untilLoaded();
  await editor.move("nose tip", "z", 9);
  await untilKept(page);
  await page.evaluate(() => (globalThis.isSamePage = true));
  await page.evaluate(() => (location.href = "manifest.webmanifest"));
  await page.waitForURL(/webmanifest/);
}

/**
 * Goes back; returns whether the browser had kept the page. Chromium 148 drops it once another tab asks for any lock.
 *
 * @param {import("@playwright/test").Page} page
 */
async function goBack(page) {
  await page.goBack({ waitUntil: "commit" });
  return page.evaluate(() => Boolean(globalThis.isSamePage));
}
