import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { keptWorks } from "./kept.mjs";
import { anotherTab, continueIn, standing, untilKept } from "./tabs.mjs";

test("work of a page that was left by a link is offered in another tab", { tag: "@way-back" }, async ({ open }) => {
  const { visitor, address } = await leave(open);
  const other = await anotherTab(visitor, address);
  await other.page.waitForSelector("#continue:not([hidden])");
  other.checkNothingBroke();
});

test("a page that is gone back to goes on with its work", { tag: "@way-back" }, async ({ open }) => {
  const { visitor, page } = await leave(open);
  assert.ok(await goBack(page), "the browser did not keep the page");
  await untilHeld(visitor, 1);
  await visitor.offset("y", 4);
  const work = await standing(visitor);
  await page.waitForTimeout(1000);
  assert.deepEqual((await keptWorks(page)).map(({ isHeld }) => isHeld), [true]);
  await page.reload();
  await continueIn(visitor);
  assert.deepEqual(await standing(visitor), work);
});

for (const [how, stays] of /** @type {const} */ ([["is open in", true], ["went on in", false]])) {
  test(`a page that is gone back to leaves alone the work that ${how} another tab`, { tag: "@way-back" }, async ({ open }) => {
    const { visitor, page, address } = await leave(open);
    const other = await anotherTab(visitor, address);
    await continueIn(other);
    await other.findLandmark("bottom of the chin");
    await other.offset("y", -6);
    const others = await standing(other);
    await other.page.waitForTimeout(600);
    if (!stays) await other.page.close();

    await page.bringToFront();
    const work = (await goBack(page)) ? await goOn(visitor) : undefined;
    if (stays) {
      await other.page.bringToFront();
      await other.page.reload();
    }
    const next = stays ? other : await anotherTab(visitor, address);
    await continueIn(next);
    assert.deepEqual(await standing(next), others);
    if (work) {
      await page.bringToFront();
      await page.reload();
      await continueIn(visitor);
      assert.deepEqual(await standing(visitor), work);
    }
    next.checkNothingBroke();
  });
}

/** Edits a face and follows a link to somewhere else. */
async function leave(open) {
  const visitor = await open();
  const { page } = visitor;
  const address = page.url();
  await visitor.untilLoaded();
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 9);
  await untilKept(visitor, 1);
  await page.evaluate(() => (globalThis.isSamePage = true));
  await page.evaluate(() => (location.href = "manifest.webmanifest"));
  await page.waitForURL(/webmanifest/);
  return { visitor, page, address };
}

/** Another edit to a face whose work has been continued elsewhere: it is kept beside that. */
async function goOn(visitor) {
  await untilKept(visitor, 2);
  await visitor.offset("y", 4);
  const work = await standing(visitor);
  await visitor.page.waitForTimeout(1000);
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

async function untilHeld({ page }, count) {
  const held = async () => (await keptWorks(page)).filter(({ isHeld }) => isHeld).length;
  for (let tries = 0; (await held()) !== count; tries += 1) {
    assert.ok(tries < 50, `${await held()} works are held`);
    await page.waitForTimeout(100);
  }
}
