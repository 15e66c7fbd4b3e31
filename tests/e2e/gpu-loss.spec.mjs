import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";
import { crashGpu, recordGpus } from "./page-scripts.mjs";

test.use({ visit: { scripts: [recordGpus] } });

for (const { drawn, needs } of [
  { drawn: "WebGPU", needs: "eyes" },
  { drawn: "WebGL2", needs: "webgl" },
]) {
  test(`the view and the work recover when the GPU process crashes under ${drawn}`, { tag: `@${needs}` }, async ({ editor, page }) => {
    await editor.move("nose tip", "z", 9);
    const before = { view: await editor.view(), mesh: await editor.meshJson("mm") };
    const gpus = await page.evaluate("gpus.length");
    await crashGpu(page);
    await page.waitForFunction((gpus) => window.gpus.length > gpus, gpus);
    assert.ok(difference(before.view, await editor.view()) < 0.001, "the view has changed");
    assert.deepEqual(await editor.meshJson("mm"), before.mesh);
    await editor.setOffset("y", 9);
    assert.ok(difference(before.view, await editor.view()) > 0.002, "edits no longer change the picture");
    await page.click("#toolbar [data-action='undo']");
    assert.deepEqual(await editor.meshJson("mm"), before.mesh);
    assert.ok(await page.isHidden("#notice"));
  });
}

test("while the WebGL2 context is lost a notice appears and edits continue; they show when it is restored", { tag: "@webgl" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  const found = await editor.view();
  const canvas = page.locator("#viewport");
  const extension = await canvas.evaluateHandle((canvas) => canvas.getContext("webgl2").getExtension("WEBGL_lose_context"));
  await extension.evaluate((extension) => extension.loseContext());
  await editor.setOffset("y", 9);
  const { code, text } = await editor.notice();
  assert.equal(code, "device-lost");
  assert.match(text, /work is saved/);
  assert.deepEqual(await editor.history(), ["nose tip"]);
  await extension.evaluate((extension) => extension.restoreContext());
  await page.waitForSelector("#notice", { state: "hidden" });
  const moved = await editor.view();
  assert.ok(difference(found, moved) > 0.002, "the edit does not show");
  await page.click("#toolbar [data-action='undo']");
  assert.ok(difference(found, await editor.view()) < 0.001, "the face has changed");
});
