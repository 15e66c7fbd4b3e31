import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { variants, test } from "./fixtures.mjs";
import { untilSaved } from "./storage.mjs";

test.use({ visit: { expert: true } });

test("files are named after the photo, also after a reload and from saved files", async ({ visitor, page }) => {
  await visitor.dropSample('ana: "Rio" 7.2.png');
  const actions = { "download-glb": "glb", "download-json": "json", "save-project": "rosto" };
  for (const [action, ending] of Object.entries(actions)) assert.equal(await nameOf(visitor, action), `ana Rio 7.2.${ending}`);
  await page.selectOption("#export-density", "1");
  assert.equal(await nameOf(visitor, "download-glb"), "ana Rio 7.2-1833.glb");
  assert.equal(await nameOf(visitor, "download-obj"), "ana Rio 7.2-1833.zip");
  assert.equal(await nameOf(visitor, "save-project"), "ana Rio 7.2.rosto");
  const glb = await visitor.download("download-glb");
  const project = await visitor.download("save-project");

  await visitor.reloadAndResume();
  assert.equal(await nameOf(visitor, "save-project"), "ana Rio 7.2.rosto");

  // A renamed file keeps its name, without repeating the number of points.
  for (const { bytes, name, says } of [
    { bytes: project, name: "bia.rosto", says: "bia-1833.glb" },
    { bytes: glb, name: "clara-1833.glb", says: "clara-1833.glb" },
  ]) {
    await visitor.drop(bytes, name);
    await page.waitForSelector("#progress", { state: "hidden" });
    await expect.poll(() => nameOf(visitor, "download-glb")).toBe(says);
  }
});

for (const [{ name, says }, tag] of variants([
  { name: "image.png", says: "face.rosto" },
  { name: "..", says: "face.rosto" },
  { name: "CON.png", says: "face.rosto" },
  { name: "María\u202egnp.exe.png", says: "Maríagnp.exe.rosto" },
])) {
  test(`a photo called ${JSON.stringify(name)} gives ${says}`, { tag }, async ({ visitor }) => {
    await visitor.dropSample(name);
    assert.equal(await nameOf(visitor, "save-project"), says);
  });
}

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

for (const [character, count] of /** @type {const} */ ([["👍🏽", 20], ["面", 53], ["a", 160], ["é", 80]])) {
  test(`a long name of “${character}” is cut between characters and fits file systems`, { tag: "@rare" }, async ({ visitor, page }) => {
    await visitor.openFace(character.repeat(200));
    const stem = character.repeat(count);
    assert.equal(await nameOf(visitor, "save-project"), `${stem}.rosto`);
    await visitor.reveal("#export-density");
    await page.selectOption("#export-density", "3");
    const names = [`${stem}-28881.3mf`, `${stem}-before-after.png`];
    for (const [index, action] of ["download-3mf", "download-pair"].entries()) {
      assert.equal(await nameOf(visitor, action), names[index]);
      assert.ok(Buffer.byteLength(names[index] ?? "") <= 200);
    }
  });
}

test("a photo from the camera is named selfie", { tag: "@camera" }, async ({ visitor }) => {
  await visitor.page.click("#welcome [data-action='camera']");
  await visitor.page.click("#camera-shutter:enabled");
  await visitor.untilFace();
  assert.equal(await nameOf(visitor, "save-project"), "selfie.rosto");
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
