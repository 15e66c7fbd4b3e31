import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { SAMPLE } from "./visitor.mjs";

for (const what of ["photo", "project"]) {
  test(`a ${what} is saved even if the page is left as soon as its face is shown`, async ({ visitor, page, project }) => {
    await visitor.untilLoaded();
    await page.evaluate(leaveOnceShown);
    const left = page.waitForEvent("framenavigated");
    if (what === "photo") await visitor.drop(await readFile(SAMPLE), "portrait.png");
    else await visitor.drop(project, "portrait.rosto");
    await left;
    await visitor.resume();
    assert.deepEqual(await visitor.history(), []);
    assert.equal((await visitor.save("save-project")).name, "portrait.rosto");
  });
}

test("an edit made as soon as a face is shown is saved even if the page is left at once", async ({ visitor, page }) => {
  await visitor.untilLoaded();
  await page.evaluate(leaveOnceShown, { slider: "#slider-nose-width .number-field", amount_mm: "3" });
  const left = page.waitForEvent("framenavigated");
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await left;
  await visitor.resume();
  assert.equal((await visitor.history()).length, 1);
  await visitor.unfold("section-face");
  assert.equal(await page.inputValue("#slider-nose-width .number-field"), "3");
});

/** Runs in the page: reloads it in the task in which it shows a face, after an edit if there is one. */
function leaveOnceShown(edit) {
  const observer = new MutationObserver(() => {
    if (document.body.dataset.state !== "face") return;
    observer.disconnect();
    if (edit) {
      const field = document.querySelector(edit.slider);
      field.value = edit.amount_mm;
      for (const type of ["input", "change"]) field.dispatchEvent(new Event(type));
    }
    location.reload();
  });
  observer.observe(document.body, { attributes: true });
}
