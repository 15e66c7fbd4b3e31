import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { journey } from "./journey.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** A square photo of 12 megapixels. */
const LARGE = { width: 3464, height: 3464 };
const LONG_TASK_MS = 50;

journey("no task on the main thread is long from a drop of 12 megapixels to the mesh", async (open) => {
  const visitor = await open();
  await visitor.untilLoaded();
  const photo = await asJpeg(visitor.page, await readFile(SAMPLE), LARGE);
  // The photo is on the page before the clock starts: in life it comes from a disk, not through a test's wire.
  await visitor.page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    globalThis.dropped = new DataTransfer();
    globalThis.dropped.items.add(new File([bytes], "large.jpg"));
  }, photo.toString("base64"));
  await visitor.frames(10);
  await visitor.page.evaluate(() => {
    globalThis.tasks_ms = [];
    new PerformanceObserver((list) => globalThis.tasks_ms.push(...list.getEntries().map(({ duration }) => duration))).observe({
      type: "longtask",
    });
    dispatchEvent(new DragEvent("drop", { dataTransfer: globalThis.dropped, bubbles: true, cancelable: true }));
  });
  await visitor.untilFace();
  await visitor.frames(10);
  const tasks_ms = await visitor.page.evaluate(() => globalThis.tasks_ms);
  assert.deepEqual(tasks_ms.filter((task_ms) => task_ms > LONG_TASK_MS), []);
});
