import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { PNG } from "pngjs";
import { meshByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { assertSameMesh } from "./meshes.mjs";
import { colourCount, difference } from "./pixels.mjs";
import { assertPortraitColours } from "./portrait-colours.mjs";
import { validateGlb } from "./validate-glb.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

const FOR_WEBGPU = "rosto-studio-web_bg.wasm";
const FOR_WEBGL2 = "rosto-studio-webgl_bg.wasm";

test("without a WebGPU adapter, the page works with WebGL2", { tag: ["@webgl", "@usual"] }, async ({ visitor, page }) => {
  assert.equal(await page.evaluate(async () => (await navigator.gpu?.requestAdapter()) ?? null), null);
  await visitor.untilLoaded();
  await page.click("#welcome [data-action='sample']");
  await visitor.untilFace();
  assert.equal(await contextKind(page), "webgl2");
  const found = await visitor.view();
  await assertPortraitColours(found);

  await visitor.findLandmark("nose tip");
  const held = await visitor.view();
  await visitor.setOffset("y", 9);
  const moved = await visitor.view();
  assert.ok(difference(held, moved) > 0.002, "the number did not change the picture");
  await visitor.drag(await visitor.selectionPosition(), { x: 0, y: -30 });
  assert.equal((await visitor.history()).length, 2, "the drag moved no landmark");
  assert.ok(difference(moved, await visitor.view()) > 0.002, "the drag did not change the picture");

  const glb = await visitor.download("download-glb");
  assert.deepEqual(await validateGlb(glb), { clean: true, counts: "0/0/0/0", messages: [] });
  const picture = PNG.sync.read(await visitor.download("download-picture"));
  assert.ok(colourCount(picture) > 40, "the picture that was downloaded is blank");
  assert.equal(picture.data[3], 0, "the picture is not transparent around the face");
});

test("without navigator.gpu, only the WebGL2 module is downloaded, and it gives the command line's mesh", { tag: "@webgl" }, async ({ open }) => {
  const visitor = await open({ scripts: ["delete Navigator.prototype.gpu"] });
  await visitor.dropSample();
  const asked = visitor.requests.map((url) => new URL(url).pathname.split("/").at(-1));
  assert.ok(asked.includes(FOR_WEBGL2) && !asked.includes(FOR_WEBGPU), asked.join(" "));
  await visitor.choosePreset("paper");
  await visitor.move("nose tip", "z", 12);
  const edit = `${await visitor.selectedLandmark()}:0,0,12:${(await visitor.anchors()).join(",")}`;
  const options = ["--units", "mm", "--density", "0", "--edit", edit];
  assertSameMesh(await visitor.meshJson("mm"), await meshByCommandLine(SAMPLE, options));
});

test("with WebGPU, the WebGL2 module is not downloaded", async ({ open }) => {
  const visitor = await open({ serviceWorkers: "allow" });
  await visitor.untilLoaded();
  assert.equal(await contextKind(visitor.page), "webgpu");
  assert.ok(visitor.requests.some((url) => url.endsWith(FOR_WEBGPU)));
  assert.deepEqual(visitor.requests.filter((url) => /webgl/.test(url)), []);
  assert.ok(await isStored(visitor.page, FOR_WEBGPU) && !(await isStored(visitor.page, FOR_WEBGL2)));
});

test("after the first visit, the page works offline with WebGL2", { tag: "@webgl" }, async ({ open }) => {
  const visitor = await open({ serviceWorkers: "allow" });
  const { page } = visitor;
  await visitor.untilLoaded();
  await expect.poll(() => isStored(page, FOR_WEBGL2)).toBe(true);
  await page.context().setOffline(true);
  await page.reload();
  await page.click("#welcome [data-action='sample']");
  await visitor.untilFace();
  assert.equal(await contextKind(page), "webgl2");
  assert.ok(colourCount(await visitor.view()) > 40);
});

test("without WebGPU and WebGL2, a notice appears, and the photo shows the landmarks", { tag: ["@no-gpu", "@usual"] }, async ({ visitor, page }) => {
  const { code, text } = await visitor.notice();
  assert.equal(code, "no-webgl");
  assert.match(text, /can’t show 3D/);
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await page.waitForSelector("body[data-state='photo']");
  const photo = PNG.sync.read(await page.locator("#photo-picture").screenshot());
  assert.ok(colourCount(photo) > 100, "the photo is not drawn");
});

/** @param {import("@playwright/test").Page} page */
function contextKind(page) {
  return page.locator("#viewport").evaluate((canvas) => ["webgpu", "webgl2"].find((kind) => canvas.getContext(kind)));
}

/**
 * Whether the service worker has stored a module.
 *
 * @param {import("@playwright/test").Page} page
 * @param {string} file
 */
function isStored(page, file) {
  return page.evaluate((file) => caches.keys().then((names) => Promise.all(names.map(async (name) => (await (await caches.open(name)).keys()).map(({ url }) => url)))).then((urls) => urls.flat().some((url) => url.endsWith(file))), file);
}
