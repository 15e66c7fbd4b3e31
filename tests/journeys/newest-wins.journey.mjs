import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { assertCameBack } from "./meshes.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** 12 megapixels, as a phone takes them. */
const LARGE = { width: 4000, height: 3000 };

test("of a large photo and a GLB right after it, the GLB stays", { tag: "@rare" }, async ({ visitor, page }) => {
  const large = await asJpeg(page, await readFile(SAMPLE), LARGE);
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 9);
  const work = await visitor.meshJson("mm");
  const history = await visitor.history();
  const glb = await visitor.download("download-glb");
  await page.click("#toolbar [data-action='undo']");

  await dropBoth(page, large, glb, 60);
  await page.waitForSelector("#progress", { state: "hidden" });
  await page.waitForFunction(() => document.querySelectorAll("#history li").length === 1);
  // Time enough for the photo to come after all.
  await page.waitForTimeout(6000);
  assert.deepEqual(await visitor.history(), history);
  assertCameBack(await visitor.meshJson("mm"), work);
  assert.ok(await page.isHidden("#notice"));
  assert.ok(await page.isHidden("#progress"));
});

test("of a large photo and a small one right after it, the small one stays", async ({ visitor, page }) => {
  const portrait = await readFile(SAMPLE);
  const large = await asJpeg(page, portrait, LARGE);
  await visitor.dropSample();
  const small = await visitor.meshJson("image");
  await visitor.drop(large, "large.jpg");
  await page.waitForSelector("#progress:not([hidden])");
  await visitor.untilFace();
  assert.notDeepEqual(await visitor.meshJson("image"), small);

  await dropBoth(page, large, portrait, 60);
  await page.waitForTimeout(6000);
  await visitor.untilFace();
  assert.deepEqual(await visitor.meshJson("image"), small);
  assert.ok(await page.isHidden("#notice"));
});

/** Drops one file, and another so many ms later. */
function dropBoth(page, first, second, pause_ms) {
  return page.evaluate(
    async ({ files, pause_ms }) => {
      for (const [place, base64] of files.entries()) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([bytes], `file-${place}`, { type: place === 0 ? "image/jpeg" : "" }));
        if (place > 0) await new Promise((resolve) => setTimeout(resolve, pause_ms));
        document.getElementById("stage").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    { files: [first, second].map((file) => Buffer.from(file).toString("base64")), pause_ms },
  );
}
