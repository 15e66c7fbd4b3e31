import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { partsOfGlb } from "./changed-files.mjs";
import { glbByCommandLine, meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameShape, maxDisplacement } from "./meshes.mjs";
import { faceless } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** Presses of an arrow key that turn the face far enough to show a side. */
const PRESSES = 7;

/** Saves a picture of the turned 3D face, which serves as another photo of the head. */
async function turnedPhoto(visitor, key) {
  const { page } = visitor;
  await page.focus("#viewport");
  for (let press = 0; press < PRESSES; press++) await page.keyboard.press(key);
  await visitor.frames(5);
  const file = test.info().outputPath(`${key}.png`);
  await writeFile(file, await visitor.download("download-picture"));
  await page.click("#toolbar [data-action='reset-view']");
  return file;
}

/**
 * Waits for `count` photos in the list and for their face.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @param {number} count
 */
async function untilPhotos(visitor, count) {
  await expect(visitor.page.locator("#photo-list li")).toHaveCount(count);
  await visitor.untilFace();
}

/** Side that each photo shows. @param {import("@playwright/test").Page} page */
async function sidesIn(page) {
  const rows = await page.locator("#photo-list li span").allInnerTexts();
  return rows.map((row) => /front|left|right/.exec(row)?.[0]);
}

test("photos from other sides change the mesh like on the command line, are saved, and can be removed", async ({ visitor, page }) => {
  await visitor.dropSample();
  const alone = await visitor.meshJson("mm");
  const [one, other] = [await turnedPhoto(visitor, "ArrowLeft"), await turnedPhoto(visitor, "ArrowRight")];
  await visitor.move("nose tip", "z", 9);

  await page.setInputFiles("#further-files", one);
  await untilPhotos(visitor, 2);
  assert.equal((await sidesIn(page)).filter((side) => side === "front").length, 1);
  assert.match(await page.innerText("#photos-missing"), /turned 20–60° to its (left|right)/);
  await page.setInputFiles("#further-files", other);
  await untilPhotos(visitor, 3);
  assert.ok(await page.isHidden("#photos-missing"), await page.innerText("#photos-missing"));
  assert.equal((await visitor.history()).length, 1, "the edit was lost");
  await page.click("#toolbar [data-action='undo']");
  const together = await visitor.meshJson("mm");
  assert.ok(maxDisplacement(alone, together) > 0.05, "the mesh has not changed");
  assertSameShape(together, await meshByCommandLine(SAMPLE, [one, other, "--units", "mm", "--density", "2"]));
  const glb = await visitor.download("download-glb");
  const [made, wanted] = [partsOfGlb(glb), partsOfGlb(await glbByCommandLine(SAMPLE, [one, other, "--units", "mm", "--density", "2"]))];
  assert.equal(made.json.meshes[0].primitives.length, wanted.json.meshes[0].primitives.length);
  assert.equal(made.json.scenes[0].extras.photos.length, 3);
  await page.click("#toolbar [data-action='redo']");
  const edited = await visitor.meshJson("mm");

  await page.reload();
  await visitor.resume();
  await untilPhotos(visitor, 3);
  assert.deepEqual(await visitor.meshJson("mm"), edited, "the mesh differs after the reload");
  await visitor.drop(glb, "portrait.glb");
  await visitor.untilFace();
  await expect(page.locator("#history .check")).toHaveCount(0);
  await untilPhotos(visitor, 3);
  assert.deepEqual((await visitor.meshJson("mm")).positions, together.positions, "the mesh differs after reopening");

  await page.click('[data-tab-name="shape"]');
  await page.locator("#photo-list li button").nth(2).click();
  await expect(page.locator("#photo-list li")).toHaveCount(2);
  await page.locator("#photo-list li button").nth(1).click();
  await page.waitForSelector("#photo-list", { state: "hidden" });
  await visitor.untilFace();
  assert.deepEqual((await visitor.meshJson("mm")).positions, alone.positions, "the mesh differs from that of the first photo");
});

test("a photo without a face is rejected by name, and one from the same side is reported to add little", async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 9);
  const before = await visitor.meshJson("mm");
  await page.setInputFiles("#further-files", { name: "wall.png", mimeType: "image/png", buffer: Buffer.from(faceless()) });
  const { code, text } = await visitor.notice();
  assert.equal(code, "no-face-found");
  assert.match(text, /“wall.png” couldn’t be added/);
  assert.deepEqual(await visitor.meshJson("mm"), before);
  await page.click("#notice-close");
  await page.setInputFiles("#further-files", SAMPLE);
  await untilPhotos(visitor, 2);
  assert.equal((await visitor.notice()).code, "adds-little");
  assert.equal((await visitor.history()).length, 1);
});

test("a photo is removed once, however often its button is pressed, and can be restored by mouse or keyboard", async ({ visitor, page }) => {
  await visitor.dropSample();
  await page.setInputFiles("#further-files", [await turnedPhoto(visitor, "ArrowLeft"), await turnedPhoto(visitor, "ArrowRight")]);
  await untilPhotos(visitor, 3);
  const together = await visitor.meshJson("mm");
  await page.click('[data-tab-name="shape"]');
  const [front, second, third] = await sidesIn(page);

  await page.locator("#photo-list li button").nth(1).dblclick();
  await untilPhotos(visitor, 2);
  assert.equal((await sidesIn(page)).at(1), third, "another photo was removed");
  assert.ok(await page.isVisible("#photo-removed"));
  await page.click("#restore-photo");
  await untilPhotos(visitor, 3);
  assert.ok(await page.isHidden("#photo-removed"));
  assert.equal((await sidesIn(page)).at(2), second);

  await page.locator("#photo-list li button").nth(2).evaluate((button) => {
    for (let press = 0; press < 3; press++) button.click();
  });
  await untilPhotos(visitor, 2);
  assert.equal((await sidesIn(page)).at(1), third);
  await page.focus("#restore-photo");
  await page.keyboard.press("Enter");
  await untilPhotos(visitor, 3);
  assert.ok(maxDisplacement(together, await visitor.meshJson("mm")) < 1e-6, "the mesh is not that of the same photos");

  // Two clicks in one task remove these two photos.
  await page.click('[data-tab-name="shape"]');
  await page.evaluate(() => {
    const [, second, third] = document.querySelectorAll("#photo-list li button");
    second.click();
    third.click();
  });
  await page.waitForSelector("#photo-list", { state: "hidden" });
  await visitor.untilFace();
  await page.click("#restore-photo");
  await untilPhotos(visitor, 2);
  assert.equal((await sidesIn(page)).at(0), front);
});
