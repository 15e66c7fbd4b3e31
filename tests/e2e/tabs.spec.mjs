import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { chooseFace, openGroup, openOther } from "./groups.mjs";
import { storedWorks, untilSaved } from "./storage.mjs";

test("two tabs save separate works, and each restores its own face and edits", async ({ editor: first, page }) => {
  await first.move("nose tip", "z", 9);
  await untilSaved(page);
  const [kept] = await storedWorks(page);

  const second = await first.openTab();
  // The first tab's work is not offered while it is open there.
  assert.ok(await second.page.isHidden("#continue"));
  await openOther(second);
  await second.move("bottom of the chin", "y", -6);
  const others = await second.work();
  await untilSaved(second.page, 2);
  assert.deepEqual((await storedWorks(page)).find(({ slot }) => slot === kept.slot), kept);

  await page.bringToFront();
  await first.setOffset("y", 4);
  const work = await first.work();
  assert.notDeepEqual(work.mesh, others.mesh);
  await untilSaved(page, 2);

  await page.reload();
  await first.resume();
  assert.deepEqual(await first.work(), work);
  await second.reloadAndResume();
  assert.deepEqual(await second.work(), others);
});

test("two new tabs offer the works of two closed ones, latest first, and make no copies", async ({ editor: first, page }) => {
  await first.move("nose tip", "z", 9);
  await untilSaved(page);
  const second = await first.openTab();
  await openOther(second);
  await second.move("bottom of the chin", "y", -6);
  const others = await second.work();
  await untilSaved(second.page, 2);
  await page.bringToFront();
  await first.setOffset("y", 4);
  const work = await first.work();
  await untilSaved(page, 2);

  await page.close();
  const third = await second.openTab();
  await second.page.close();
  await third.resume();
  assert.deepEqual(await third.work(), work);
  const fourth = await third.openTab();
  await fourth.resume();
  assert.deepEqual(await fourth.work(), others);
  // Reopening makes no copies, which would displace other works.
  await untilSaved(fourth.page);
  const both = await storedWorks(fourth.page);
  assert.equal(both.length, 2);

  // Another photo in the tab leaves the previous work unchanged.
  await openOther(fourth);
  await untilSaved(fourth.page, 3);
  const now = await storedWorks(fourth.page);
  assert.equal(now.length, 3);
  for (const { slot, edits } of both) assert.deepEqual(now.find((one) => one.slot === slot)?.edits, edits);
});

test("a face edited in another tab is restored in the first tab as left there", async ({ visitor: first, page }) => {
  await openGroup(first);
  await first.move("nose tip", "z", 9);
  await untilSaved(page);
  const left = await first.work();
  const choose = async (index) => {
    await chooseFace(first, index);
    await expect(page.locator("#history .check")).toHaveCount(index === 0 ? 1 : 0);
  };
  await choose(1);
  await untilSaved(page, 2);

  const second = await first.openTab();
  await second.resume();
  assert.deepEqual(await second.work(), left);
  await second.move("bottom of the chin", "y", -6);
  const others = await second.work();
  await untilSaved(second.page);

  await page.bringToFront();
  await choose(0);
  assert.deepEqual(await first.work(), left);
  await first.move("nose tip", "y", 2);
  const work = await first.work();
  await untilSaved(page, 3);
  assert.deepEqual(await second.work(), others);
  for (const [visitor, expected] of [[first, work], [second, others]]) {
    await visitor.page.bringToFront();
    await visitor.reloadAndResume();
    assert.deepEqual(await visitor.work(), expected);
  }
});

test("work open in another tab is reported, or the next work opens", async ({ editor: first, page }) => {
  await first.move("nose tip", "z", 9);
  await untilSaved(page);
  await page.reload();
  const [second, third] = [await first.openTab(), await first.openTab()];
  for (const { page } of [first, second, third]) await page.waitForSelector("#continue:not([hidden])");
  await first.resume();
  const work = await first.work();

  await second.page.bringToFront();
  await second.page.click("#continue");
  const { code, text } = await second.notice();
  assert.equal(code, "open-elsewhere");
  assert.match(text, /open in another tab/);
  await second.setLanguage("pt");
  assert.match((await second.notice()).text, /aberto em outra aba/);
  await second.setLanguage("en");

  // With two works, the other tab gets the free one.
  await openOther(second);
  await second.move("bottom of the chin", "y", -6);
  await untilSaved(second.page, 2);
  const others = await second.work();
  await second.page.close();
  await third.page.bringToFront();
  await third.resume();
  assert.equal((await third.notice()).code, "earlier-work");
  assert.deepEqual(await third.work(), others);
  assert.deepEqual(await first.work(), work);
  assert.equal((await storedWorks(page)).length, 2);
});
