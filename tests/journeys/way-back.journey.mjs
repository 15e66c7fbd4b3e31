import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { keptWorks, untilKept } from "./kept.mjs";

test("work of a page that was left by a link is offered in another tab", { tag: "@way-back" }, async ({ open }) => {
  const { visitor } = await leave(open);
  const other = await visitor.anotherTab();
  await other.page.waitForSelector("#continue:not([hidden])");
});

test("a page that is gone back to goes on with its work", { tag: "@way-back" }, async ({ open }) => {
  const { visitor, page } = await leave(open);
  assert.ok(await goBack(page), "the browser did not keep the page");
  await expect.poll(async () => (await keptWorks(page)).filter(({ isHeld }) => isHeld).length).toBe(1);
  await visitor.offset("y", 4);
  const work = await visitor.work();
  await untilKept(page);
  assert.deepEqual((await keptWorks(page)).map(({ isHeld }) => isHeld), [true]);
  await visitor.comeBack();
  assert.deepEqual(await visitor.work(), work);
});

for (const [how, stays] of /** @type {const} */ ([["is open in", true], ["went on in", false]])) {
  test(`a page that is gone back to leaves alone the work that ${how} another tab`, { tag: "@way-back" }, async ({ open }) => {
    const { visitor, page } = await leave(open);
    const other = await visitor.anotherTab();
    await other.resume();
    await other.move("bottom of the chin", "y", -6);
    const others = await other.work();
    await untilKept(other.page);
    if (!stays) await other.page.close();

    await page.bringToFront();
    const work = (await goBack(page)) ? await goOn(visitor) : undefined;
    if (stays) {
      await other.page.bringToFront();
      await other.page.reload();
    }
    const next = stays ? other : await visitor.anotherTab();
    await next.resume();
    assert.deepEqual(await next.work(), others);
    if (work) {
      await page.bringToFront();
      await visitor.comeBack();
      assert.deepEqual(await visitor.work(), work);
    }
  });
}

/** Edits a face and follows a link to somewhere else. */
async function leave(open) {
  const visitor = await open();
  const { page } = visitor;
  await visitor.untilLoaded();
  await visitor.openFace();
  await visitor.move("nose tip", "z", 9);
  await untilKept(visitor.page);
  await page.evaluate(() => (globalThis.isSamePage = true));
  await page.evaluate(() => (location.href = "manifest.webmanifest"));
  await page.waitForURL(/webmanifest/);
  return { visitor, page };
}

/** Another edit to a face whose work has been continued elsewhere: it is kept beside that. */
async function goOn(visitor) {
  await untilKept(visitor.page, 2);
  await visitor.offset("y", 4);
  const work = await visitor.work();
  await untilKept(visitor.page);
  assert.equal((await keptWorks(visitor.page)).length, 2);
  return work;
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
