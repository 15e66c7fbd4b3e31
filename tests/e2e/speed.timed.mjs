import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { asJpeg } from "./pictures.mjs";
import { mainThreadTasks, traced } from "./trace.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

/** Size of a 12-megapixel photo. */
const LARGE = { width: 4000, height: 3000 };
const LONG_TASK_MS = 50;
/** Time per frame at 60 Hz. */
const FRAME_MS = 16;
const DRAG_STEPS = 40;
/** Number of tasks to print. */
const SHOWN = 5;
test("no main-thread task is long between the drop of a 12-megapixel photo and its mesh", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.untilLoaded();
  const photo = await asJpeg(page, await readFile(SAMPLE), LARGE);
  // The photo is in the page before the trace starts, to exclude the transfer from the test.
  await page.evaluate((bytes) => {
    globalThis.dropped = new DataTransfer();
    globalThis.dropped.items.add(new File([bytes], "large.jpg"));
  }, new Uint8Array(photo));
  await visitor.frames(10);

  const events = await traced(page, async () => {
    await page.evaluate(() => dispatchEvent(new DragEvent("drop", { dataTransfer: globalThis.dropped, bubbles: true, cancelable: true })));
    await visitor.untilFace();
    // Includes the autosave of the face, half a second later.
    await visitor.frames(30);
  });
  const tasks = mainThreadTasks(events);
  for (const { took_ms, held } of tasks.slice(0, SHOWN)) console.log(`    ${took_ms.toFixed(1)} ms: ${held}`);
  const [longest] = tasks;
  assert.ok(longest && longest.took_ms <= LONG_TASK_MS, `a task took ${longest?.took_ms.toFixed(0)} ms`);
});

test("each drag step takes less than a frame on the main thread, also on the densest mesh", { tag: "@eyes" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  for (const density of ["0", "3"]) {
    await page.selectOption("#density", density, { force: true });
    await visitor.findLandmark("nose tip");
    const tip = await visitor.tagPosition();
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
