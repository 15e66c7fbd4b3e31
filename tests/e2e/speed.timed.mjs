import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { asJpeg } from "./pictures.mjs";
import { mainThreadTasks, traced } from "./trace.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

/** What a 12-megapixel camera takes. */
const LARGE = { width: 4000, height: 3000 };
const LONG_TASK_MS = 50;
/** What a screen of 60 Hz leaves for a frame. */
const FRAME_MS = 16;
const DRAG_STEPS = 40;
/** How many tasks are told. */
const SHOWN = 5;
test("no task on the main thread is long from a drop of 12 megapixels to the mesh", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();
  const photo = await asJpeg(page, await readFile(SAMPLE), LARGE);
  // The photo is on the page before the clock starts: in life it comes from a disk, not through a test's wire.
  await page.evaluate((bytes) => {
    globalThis.dropped = new DataTransfer();
    globalThis.dropped.items.add(new File([bytes], "large.jpg"));
  }, new Uint8Array(photo));
  await visitor.frames(10);

  const events = await traced(page, async () => {
    await page.evaluate(() => dispatchEvent(new DragEvent("drop", { dataTransfer: globalThis.dropped, bubbles: true, cancelable: true })));
    await visitor.untilFace();
    // Half a second more, in which the face is stored for the next visit.
    await visitor.frames(30);
  });
  const tasks = mainThreadTasks(events);
  for (const { took_ms, held } of tasks.slice(0, SHOWN)) console.log(`    ${took_ms.toFixed(1)} ms: ${held}`);
  const [longest] = tasks;
  assert.ok(longest && longest.took_ms <= LONG_TASK_MS, `a task took ${longest?.took_ms.toFixed(0)} ms`);
});

test("each step of a drag takes the main thread less than a frame, on the densest mesh, too", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  for (const density of ["0", "3"]) {
    await page.selectOption("#density", density, { force: true });
    await visitor.findLandmark("nose tip");
    const tip = await visitor.tagged();
    await page.mouse.move(tip.x, tip.y);
    await page.mouse.down();
    await page.mouse.move(tip.x, tip.y - 10, { steps: 3 });
    await visitor.frames(10);
    const events = await traced(page, async () => {
      for (let step = 0; step < DRAG_STEPS; step++) {
        await page.mouse.move(tip.x, tip.y - 10 - step);
        await visitor.frames(1);
      }
    });
    const [longest] = mainThreadTasks(events);
    console.log(`    density ${density}, ${longest?.took_ms.toFixed(1)} ms: ${longest?.held}`);
    await page.mouse.up();
    assert.ok(longest && longest.took_ms <= FRAME_MS, `a step took ${longest?.took_ms.toFixed(1)} ms`);
    await page.click("#toolbar [data-action='undo']");
  }
});
