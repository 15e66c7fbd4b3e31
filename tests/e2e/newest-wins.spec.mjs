import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { assertRestored } from "./meshes.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";
import { recordWorkers } from "./page-scripts.mjs";

/** 12 megapixels. */
const LARGE = { width: 4000, height: 3000 };

test.use({ visit: { scripts: [recordWorkers] } });

test("a small photo or a GLB replaces a large photo that is still being read", async ({ visitor, page }) => {
  const portrait = await readFile(SAMPLE);
  const large = await asJpeg(page, portrait, LARGE);
  await visitor.dropSample();
  const small = await visitor.meshJson("image");
  await visitor.drop(large, "large.jpg");
  await page.waitForSelector("#progress:not([hidden])");
  await visitor.untilFace();
  assert.notDeepEqual(await visitor.meshJson("image"), small);
  await dropBoth(page, large, portrait);
  await untilOpened(visitor, 4);
  await visitor.untilFace();
  assert.deepEqual(await visitor.meshJson("image"), small);
  assert.ok(await page.isHidden("#notice"));

  await visitor.move("nose tip", "z", 9);
  const { mesh, history } = await visitor.work();
  const glb = await visitor.download("download-glb");
  await page.click("#toolbar [data-action='undo']");
  await dropBoth(page, large, glb);
  await page.waitForSelector("#progress", { state: "hidden" });
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 1);
  // The worker has still replied to the photo.
  await untilOpened(visitor, 6);
  assert.deepEqual(await visitor.history(), history);
  assertRestored(await visitor.meshJson("mm"), mesh);
  assert.ok(await page.isHidden("#notice"));
  assert.ok(await page.isHidden("#progress"));
});

/** Waits until the worker has opened `count` files. */
async function untilOpened(visitor, count) {
  await visitor.page.waitForFunction((count) => window.workerMessages.filter((type) => type === "open").length === count, count);
  await visitor.frames(5);
}

/** Drops a file, and another one a few frames later. */
function dropBoth(page, first, second) {
  return page.evaluate(
    async (files) => {
      for (const [place, bytes] of files.entries()) {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([bytes], `file-${place}`, { type: place === 0 ? "image/jpeg" : "" }));
        for (let frame = 0; frame < 4 * place; frame++) await new Promise(requestAnimationFrame);
        document.getElementById("stage").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    [new Uint8Array(first), new Uint8Array(second)],
  );
}
