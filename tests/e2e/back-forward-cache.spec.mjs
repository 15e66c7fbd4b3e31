import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { inVersion } from "./server.mjs";
import { test } from "./fixtures.mjs";
import { storedWorks, untilSaved } from "./storage.mjs";

test("a page restored from the back/forward cache continues its work", { tag: "@way-back" }, async ({ editor, page }) => {
  await leave(editor);
  assert.ok(await goBack(page), "the page was not in the back/forward cache");
  await expect.poll(async () => (await storedWorks(page)).filter(({ isLocked }) => isLocked).length).toBe(1);
  await editor.setOffset("y", 4);
  const work = await editor.work();
  await untilSaved(page);
  assert.deepEqual((await storedWorks(page)).map(({ isLocked }) => isLocked), [true]);
  await editor.reloadAndResume();
  assert.deepEqual(await editor.work(), work);
});

for (const [how, stays] of /** @type {const} */ ([["is open in", true], ["was continued in", false]])) {
  test(`a page restored from the back/forward cache does not change work that ${how} another tab`, { tag: "@way-back" }, async ({ editor, page }) => {
    await leave(editor);
    const other = await editor.openTab();
    await other.resume();
    await other.move("bottom of the chin", "y", -6);
    const others = await other.work();
    await untilSaved(other.page);
    if (!stays) await other.page.close();

    await page.bringToFront();
    let work;
    if (await goBack(page)) {
      // New edits are saved separately from the work continued elsewhere.
      await untilSaved(page, 2);
      await editor.setOffset("y", 4);
      work = await editor.work();
      await untilSaved(page);
      assert.equal((await storedWorks(page)).length, 2);
    }
    if (stays) {
      await other.page.bringToFront();
      await other.page.reload();
    }
    const next = stays ? other : await editor.openTab();
    await next.resume();
    assert.deepEqual(await next.work(), others);
    if (work) {
      await page.bringToFront();
      await editor.reloadAndResume();
      assert.deepEqual(await editor.work(), work);
    }
  });
}

/** Edits the face and navigates away. */
async function leave(editor) {
  const { page } = editor;
  await editor.untilLoaded();
  await editor.move("nose tip", "z", 9);
  await untilSaved(page);
  await page.evaluate(() => (globalThis.isSamePage = true));
  await page.evaluate((url) => (location.href = url), await inVersion("manifest.webmanifest"));
  await page.waitForURL(/webmanifest/);
}

/**
 * Goes back; returns whether the page came from the back/forward cache. Chromium 148 evicts it when another tab
 * requests a lock.
 *
 * @param {import("@playwright/test").Page} page
 */
async function goBack(page) {
  await page.goBack({ waitUntil: "commit" });
  return page.evaluate(() => Boolean(globalThis.isSamePage));
}
