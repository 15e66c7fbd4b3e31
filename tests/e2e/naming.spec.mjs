import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";
import { untilSaved } from "./storage.mjs";

test.use({ visit: { expert: true } });

test("files are named after the photo, also after a reload and from saved files", async ({ visitor, page }) => {
  await visitor.dropSample('ana: "Rio" 7.2.png');
  await page.selectOption("#export-density", "1", { force: true });
  const { name, bytes: glb } = await visitor.save("download-glb");
  assert.equal(name, "ana Rio 7.2-1833.glb");
  const { name: projectName, bytes: project } = await visitor.save("save-project");
  assert.equal(projectName, "ana Rio 7.2.rosto");
  await visitor.reloadAndResume();
  assert.equal(await nameOf(visitor, "save-project"), "ana Rio 7.2.rosto");

  // A renamed file keeps its name, without repeating the number of points.
  for (const { bytes, name, says } of [
    { bytes: project, name: "bia.rosto", says: "bia-1833.glb" },
    { bytes: glb, name: "clara-1833.glb", says: "clara-1833.glb" },
  ]) {
    await visitor.drop(bytes, name);
    await expect(page.locator("#export-file dt")).toHaveText(says);
  }
});

test("pictures with different contents get different names", async ({ visitor }) => {
  await visitor.openFace("ana");
  for (const [action, name] of [
    ["download-png", "ana-texture.png"],
    ["download-picture", "ana-view.png"],
    ["download-photo-png", "ana-edited.png"],
    ["download-photo-jpeg", "ana-edited.jpg"],
    ["download-pair", "ana-before-after.png"],
    ["download-picture", "ana-view-2.png"],
    ["download-photo-png", "ana-edited-2.png"],
    ["download-glb", "ana.glb"],
    ["download-glb", "ana.glb"],
  ]) assert.equal(await nameOf(visitor, action), name);
});

test("the sample has a thumbnail that causes no layout shift or request; returning users see Continue first", async ({ visitor, page }) => {
  await visitor.untilLoaded();
  visitor.requests.length = 0;
  await page.reload();
  await visitor.untilInteractive();
  const sample = page.locator("#welcome [data-action='sample']");
  const before = await sample.boundingBox();
  await visitor.untilLoaded();
  const colours = await page.locator("#sample-thumbnail").evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  assert.ok(colours > 50, "the thumbnail is empty");
  assert.deepEqual(await sample.boundingBox(), before);
  assert.equal(visitor.requests.filter((url) => url.endsWith("sample.png")).length, 1);
  assert.deepEqual(await offered(page), [["choose", true], ["camera", false], ["live-preview", false], ["sample", false]]);
  await sample.click();
  await visitor.untilFace();
  assert.equal(await nameOf(visitor, "save-project"), "sample.rosto");

  await untilSaved(page);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  await visitor.untilLoaded();
  assert.deepEqual(await offered(page), [["continue", true], ["choose", false], ["camera", false], ["live-preview", false], ["sample", false]]);
});

/** Buttons of the empty page in order, and whether each is primary. */
function offered(page) {
  return page.locator("#welcome button:visible").evaluateAll((buttons) =>
    buttons.map((button) => [button.dataset.action ?? button.id, button.classList.contains("primary")]),
  );
}

/** Name of a downloaded file. */
async function nameOf(visitor, action) {
  return (await visitor.save(action)).name;
}
