import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

/** A technical control on each tab, and an ordinary one. The session's tests list them. */
const TABS = {
  shape: ["#section-advanced", "#section-history"],
  view: ["#shading label:has([value='response'])", "#shading label:has([value='clay'])"],
  export: ["[data-action='download-json']", "[data-action='check-glb']"],
};

test("one switch shows technical controls and point numbers, and is remembered", async ({ editor, page }) => {
  const expectShown = async (isExpert) => {
    for (const [tab, [technical, ordinary]] of Object.entries(TABS)) {
      await page.click(`#tab-${tab}`);
      await expect(page.locator(technical)).toBeVisible({ visible: isExpert });
      await expect(page.locator(ordinary)).toBeVisible();
    }
    await editor.findLandmark("nose tip");
    assert.equal(await page.inputValue("#landmark-search"), isExpert ? "nose tip · 1" : "nose tip");
  };
  await expectShown(false);
  await page.getByLabel("Expert").check();
  await expectShown(true);
  await editor.reloadAndResume();
  await expectShown(true);
  // A technical value in use stays visible.
  await editor.reveal("#shading [value='response']");
  await page.check("#shading [value='response']", { force: true });
  await page.getByLabel("Expert").uncheck();
  assert.ok(await page.isVisible("#shading label:has([value='response'])"));
  assert.ok(await page.isHidden("#shading label:has([value='normals'])"));
});
