import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { journey } from "./journey.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** What a 12-megapixel camera takes. */
const LARGE = { width: 4000, height: 3000 };
const LONG_TASK_MS = 50;
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];

journey("no task on the main thread is long from a drop of 12 megapixels to the mesh", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.untilLoaded();
  const photo = await asJpeg(page, await readFile(SAMPLE), LARGE);
  // The photo is on the page before the clock starts: in life it comes from a disk, not through a test's wire.
  await page.evaluate((base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    globalThis.dropped = new DataTransfer();
    globalThis.dropped.items.add(new File([bytes], "large.jpg"));
  }, photo.toString("base64"));
  await visitor.frames(10);

  const browser = page.context().browser();
  await browser.startTracing(page, { categories: CATEGORIES });
  await page.evaluate(() =>
    dispatchEvent(new DragEvent("drop", { dataTransfer: globalThis.dropped, bubbles: true, cancelable: true })),
  );
  await visitor.untilFace();
  await visitor.frames(10);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const longest_ms = Math.max(...mainThreadTasks_ms(traceEvents));
  assert.ok(longest_ms > 0 && longest_ms <= LONG_TASK_MS, `a task took ${longest_ms.toFixed(0)} ms`);
});

/**
 * The processor time of each task of the page's main thread, so that what else the machine does is left out.
 *
 * @param {{ name: string, ph: string, pid: number, tid: number, tdur?: number, args: { name?: string } }[]} events
 */
function mainThreadTasks_ms(events) {
  const threads = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(threads.map(({ pid, tid }) => `${pid}:${tid}`));
  return events
    .filter(({ name, ph, pid, tid }) => name === "RunTask" && ph === "X" && main.has(`${pid}:${tid}`))
    .map(({ tdur = 0 }) => tdur / 1000);
}
