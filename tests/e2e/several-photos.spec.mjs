import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { findings } from "./boxes.mjs";
import { test } from "./fixtures.mjs";
import { asJpeg, faceless, text } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

test("several photos open a dialog by keys, and Escape leaves the work as it was", async ({ editor, page }) => {
  await editor.move("nose tip", "z", 4);
  const work = await editor.work();
  const files = [await photo(page, "ana"), notes(), await photo(page, "bia")];
  await page.setInputFiles("#photo-file", files);
  await expect(dialogOf(page)).toBeVisible();
  await expect(page.getByRole("dialog", { name: "2 photos: one face or several?" })).toBeVisible();
  const words = [];
  for (let presses = 0; presses < 3; presses++) {
    await page.keyboard.press("Tab");
    words.push(await page.evaluate(() => document.activeElement?.textContent));
  }
  assert.deepEqual(words, ["One person: use all for one face", "Different people: open each", "Cancel"]);
  await page.keyboard.press("Escape");
  await expect(dialogOf(page)).toBeHidden();
  assert.deepEqual(await editor.work(), work);
  assert.ok(await page.isHidden("#notice"));

  // One photo among other files needs no answer.
  await page.setInputFiles("#photo-file", files.slice(0, 2));
  await page.waitForSelector("#notice[data-code='one-of-several']");
  await expect(dialogOf(page)).toBeHidden();
});

test("photos of one person become one face, without those that have none", async ({ visitor, page }) => {
  await visitor.untilInteractive();
  const wall = { name: "wall.png", mimeType: "image/png", buffer: Buffer.from(faceless()) };
  await page.setInputFiles("#photo-file", [wall, await photo(page, "ana"), await photo(page, "bia", 480)]);
  await page.click("[data-action='photos-together']");
  await expect(page.locator("#photo-list li")).toHaveCount(2);
  await visitor.untilFace();
  await visitor.unfold("section-export");
  await expect(page.locator("#export-file dt")).toHaveText(/^ana/);
  assert.ok(await page.isHidden("#faces"), "a photo opened as another face");
});

test("photos of different people open each, the first one last", async ({ visitor, page }) => {
  await visitor.untilInteractive();
  const files = [await photo(page, "ana"), await photo(page, "bia", 480), await photo(page, "eva", 640)];
  await page.setInputFiles("#photo-file", files);
  await page.click("[data-action='photos-each']");
  const earlier = () => page.locator("#earlier-options button").evaluateAll((buttons) => buttons.map(({ title }) => title));
  await expect.poll(earlier).toEqual(["Back to bia", "Back to eva"]);
  await visitor.untilFace();
  assert.ok(await page.isHidden("#photo-list"), "the photos were added to one face");
});

for (const [width, height] of [[1280, 720], [390, 844]]) {
  test(`at ${width}×${height} the dialog states the limits of six photos, in both languages`, async ({ open }) => {
    const { page } = await open({ viewport: { width, height } });
    await page.waitForSelector("body[data-host='open']");
    const one = await photo(page, "ana");
    await page.setInputFiles("#photo-file", Array.from({ length: 6 }, (_, index) => ({ ...one, name: `${index}.jpg` })));
    await expect(page.locator("#several-limit")).toHaveText("One face uses at most 5 photos. At most 10 photos open at once.");
    await page.selectOption("#language", "pt", { force: true });
    await expect(page.locator("#several-title")).toHaveText("6 fotos: um rosto ou vários?");
    assert.deepEqual(await findings(page), []);
  });
}

function dialogOf(page) {
  return page.locator("#several");
}

/** The sample portrait as a JPEG file of this height in px. */
async function photo(page, name, height = 512) {
  const bytes = await asJpeg(page, await readFile(SAMPLE), { width: 512, height });
  return { name: `${name}.jpg`, mimeType: "image/jpeg", buffer: Buffer.from(bytes) };
}

function notes() {
  return { name: "notes.txt", mimeType: "text/plain", buffer: Buffer.from(text()) };
}
