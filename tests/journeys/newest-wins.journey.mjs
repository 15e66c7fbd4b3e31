import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { assertCameBack } from "./meshes.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";
import { watchWorkers } from "./watches.mjs";

/** 12 megapixels, as a phone takes them. */
const LARGE = { width: 4000, height: 3000 };

test("of a large photo and a GLB right after it, the GLB stays", { tag: "@rare" }, async ({ open }) => {
  const visitor = await open({ scripts: [watchWorkers] });
  const { page } = visitor;
  const large = await asJpeg(page, await readFile(SAMPLE), LARGE);
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 9);
  const work = await visitor.meshJson("mm");
  const history = await visitor.history();
  const glb = await visitor.download("download-glb");
  await page.click("#toolbar [data-action='undo']");

  await dropBoth(page, large, glb);
  await page.waitForSelector("#progress", { state: "hidden" });
  await page.waitForFunction(() => document.querySelectorAll("#history li").length === 1);
  // The worker has answered for the photo all the same.
  await untilFound(visitor, 2);
  assert.deepEqual(await visitor.history(), history);
  assertCameBack(await visitor.meshJson("mm"), work);
  assert.ok(await page.isHidden("#notice"));
  assert.ok(await page.isHidden("#progress"));
});

test("of a large photo and a small one right after it, the small one stays", async ({ open }) => {
  const visitor = await open({ scripts: [watchWorkers] });
  const { page } = visitor;
  const portrait = await readFile(SAMPLE);
  const large = await asJpeg(page, portrait, LARGE);
  await visitor.dropSample();
  const small = await visitor.meshJson("image");
  await visitor.drop(large, "large.jpg");
  await page.waitForSelector("#progress:not([hidden])");
  await visitor.untilFace();
  assert.notDeepEqual(await visitor.meshJson("image"), small);

  await dropBoth(page, large, portrait);
  await untilFound(visitor, 4);
  await visitor.untilFace();
  assert.deepEqual(await visitor.meshJson("image"), small);
  assert.ok(await page.isHidden("#notice"));
});

/** Waits until the worker has answered for `count` photos. */
async function untilFound(visitor, count) {
  await visitor.page.waitForFunction((count) => window.workersSaid.filter((type) => type === "found").length === count, count);
  await visitor.frames(5);
}

/** Drops one file, and another a few frames later. */
function dropBoth(page, first, second) {
  return page.evaluate(
    async (files) => {
      for (const [place, base64] of files.entries()) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([bytes], `file-${place}`, { type: place === 0 ? "image/jpeg" : "" }));
        for (let frame = 0; frame < 4 * place; frame++) await new Promise(requestAnimationFrame);
        document.getElementById("stage").dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    [first, second].map((file) => Buffer.from(file).toString("base64")),
  );
}
