import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { keptWorks } from "./kept.mjs";
import { asJpeg, twice } from "./pictures.mjs";
import { anotherTab, continueIn, standing, untilKept } from "./tabs.mjs";
import { SAMPLE } from "./visitor.mjs";

test("two tabs keep two works: each comes back with its own face and edits", async ({ open }) => {
  const first = await open();
  const { page } = first;
  const address = page.url();
  await first.dropSample();
  await first.findLandmark("nose tip");
  await first.offset("z", 9);

  const second = await anotherTab(first, address);
  // The first tab's work is not offered while it is open there.
  assert.ok(await second.page.isHidden("#continue"));
  await second.drop(await asJpeg(page, await readFile(SAMPLE), { width: 640, height: 480 }), "other.jpg");
  await second.untilFace();
  await second.findLandmark("bottom of the chin");
  await second.offset("y", -6);
  const others = await standing(second);

  await page.bringToFront();
  await first.offset("y", 4);
  const work = await standing(first);
  assert.notDeepEqual(work.mesh, others.mesh);
  await untilKept(first, 2);

  await page.reload();
  await continueIn(first);
  assert.deepEqual(await standing(first), work);
  await second.page.reload();
  await continueIn(second);
  assert.deepEqual(await standing(second), others);

  // Both are closed; the next two tabs find both, the latest first.
  await page.close();
  const third = await anotherTab(second, address);
  await second.page.close();
  await continueIn(third);
  assert.deepEqual(await standing(third), work);
  const fourth = await anotherTab(third, address);
  await continueIn(fourth);
  assert.deepEqual(await standing(fourth), others);
  // Opening them again has made no copies, which would drive other works out.
  await fourth.page.waitForTimeout(1000);
  assert.equal((await keptWorks(fourth.page)).length, 2);
  for (const visitor of [second, third, fourth]) visitor.checkNothingBroke();
});

test("a tab writes its own slot alone, and a new face does not write over the one before", { tag: "@rare" }, async ({ open }) => {
  const first = await open();
  const { page } = first;
  await first.dropSample();
  await first.findLandmark("nose tip");
  await first.offset("z", 9);
  await untilKept(first, 1);
  const [kept] = await keptWorks(first.page);

  const second = await anotherTab(first, page.url());
  await second.dropSample();
  await second.findLandmark("bottom of the chin");
  await second.offset("y", -6);
  await untilKept(second, 2);
  assert.deepEqual((await keptWorks(first.page)).find(({ slot }) => slot === kept.slot), kept);

  // Another photo in the first tab: what was done to the one before stays as it was.
  await first.drop(await asJpeg(page, await readFile(SAMPLE), { width: 640, height: 480 }), "other.jpg");
  await first.untilFace();
  await untilKept(first, 3);
  const now = await keptWorks(first.page);
  assert.equal(now.length, 3);
  assert.deepEqual(now.find(({ slot }) => slot === kept.slot)?.edits, kept.edits);
  second.checkNothingBroke();
});

test("a face that was left in one tab and goes on in another comes back in the first as it was left there", async ({ open }) => {
  const first = await open();
  const { page } = first;
  await first.drop(await twice(page, await readFile(SAMPLE)), "group.png");
  await first.untilFace();
  await first.findLandmark("nose tip");
  await first.offset("z", 9);
  await untilKept(first, 1);
  const left = await standing(first);
  const choose = async (index) => {
    await page.locator("#face-options input").nth(index).click({ force: true });
    await page.waitForFunction((count) => document.querySelectorAll("#history li").length === count, index === 0 ? 1 : 0);
  };
  await choose(1);
  await untilKept(first, 2);

  const second = await anotherTab(first, page.url());
  await continueIn(second);
  assert.deepEqual(await standing(second), left);
  await second.findLandmark("bottom of the chin");
  await second.offset("y", -6);
  const others = await standing(second);
  await second.page.waitForTimeout(600);

  await page.bringToFront();
  await choose(0);
  assert.deepEqual(await standing(first), left);
  await first.findLandmark("nose tip");
  await first.offset("y", 2);
  const work = await standing(first);
  await untilKept(first, 3);
  assert.deepEqual(await standing(second), others);
  for (const [visitor, stands] of [[first, work], [second, others]]) {
    await visitor.page.bringToFront();
    await visitor.page.reload();
    await continueIn(visitor);
    assert.deepEqual(await standing(visitor), stands);
  }
  second.checkNothingBroke();
});

test("work that is open in another tab by now is said to be there, or the next one is opened", async ({ open }) => {
  const first = await open();
  const { page } = first;
  await first.dropSample();
  await first.findLandmark("nose tip");
  await first.offset("z", 9);
  await untilKept(first, 1);
  const address = page.url();
  await page.reload();
  const second = await anotherTab(first, address);
  const third = await anotherTab(first, address);
  for (const { page } of [first, second, third]) await page.waitForSelector("#continue:not([hidden])");
  await continueIn(first);
  const work = await standing(first);

  await second.page.bringToFront();
  await second.page.click("#continue");
  const { code, text } = await second.notice();
  assert.equal(code, "open-elsewhere");
  assert.match(text, /open in another tab/);
  await second.speak("pt");
  assert.match((await second.notice()).text, /aberto em outra aba/);
  await second.speak("en");

  // Of two works, the other tab gets the one that nobody has.
  await second.drop(await asJpeg(page, await readFile(SAMPLE), { width: 640, height: 480 }), "other.jpg");
  await second.untilFace();
  await second.findLandmark("bottom of the chin");
  await second.offset("y", -6);
  await untilKept(second, 2);
  const others = await standing(second);
  await second.page.close();
  await third.page.bringToFront();
  await third.page.click("#continue");
  await third.untilFace();
  assert.equal((await third.notice()).code, "earlier-work");
  assert.deepEqual(await standing(third), others);
  assert.deepEqual(await standing(first), work);
  assert.equal((await keptWorks(page)).length, 2);
  third.checkNothingBroke();
});
