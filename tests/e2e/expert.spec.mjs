import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

/** Technical controls, by tab. */
const TECHNICAL = {
  shape: ["#preset", "#section-advanced"],
  view: ["#density", "#shading label:has([value='normals'])", "#shading label:has([value='response'])", "#shading label:has([value='distortion'])"],
  export: ["#export-density", "#export-morphs", "#export-units", "[data-action='download-json']"],
};
const ORDINARY = {
  shape: ["#shape", "#slider-nose-width", "#selection", "#landmark-offset", "#landmark-more", "#looks", "#section-history"],
  view: ["#shading label:has([value='clay'])", "#view-wireframe", "#triangulation", "[data-action='view.left']"],
  export: ["#texture-size", "[data-action='check-glb']", "#save-main", "#save-more"],
};

test("one switch shows technical controls and point numbers, and is remembered", async ({ editor, page }) => {
  const expectShown = async (isExpert) => {
    for (const tab of ["shape", "view", "export"]) {
      await page.click(`#tab-${tab}`);
      for (const selector of TECHNICAL[tab]) await expect(page.locator(selector), selector).toBeVisible({ visible: isExpert });
      for (const selector of ORDINARY[tab]) await expect(page.locator(selector), selector).toBeVisible();
    }
    await editor.findLandmark("nose tip");
    assert.equal(await page.inputValue("#landmark-search"), isExpert ? "nose tip · 1" : "nose tip");
  };
  await expectShown(false);
  await page.getByLabel("Expert").check();
  await expectShown(true);
  await editor.setOffset("z", 4);
  assert.deepEqual(await editor.history(), ["nose tip · 1"]);

  await editor.reloadAndResume();
  await expectShown(true);
  await page.getByLabel("Expert").uncheck();
  await expectShown(false);
  assert.deepEqual(await editor.history(), ["nose tip"]);
});

test("technical choices stay in effect when the switch is off", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.choosePreset("paper");
  await editor.reveal("#shading [value='response']");
  await page.check("#shading [value='response']", { force: true });
  await page.getByLabel("Expert").uncheck();
  assert.ok(await page.isVisible("#shading label:has([value='response'])"), "the active display is not shown");
  assert.ok(await page.isHidden("#shading label:has([value='normals'])"));
  await editor.move("nose tip", "z", 4);
  assert.equal((await editor.anchors()).length, 2, "the paper's preset is no longer in effect");
});
