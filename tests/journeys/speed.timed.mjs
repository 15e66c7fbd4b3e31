import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { journey } from "./journey.mjs";
import { asJpeg } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** What a 12-megapixel camera takes. */
const LARGE = { width: 4000, height: 3000 };
const LONG_TASK_MS = 50;
/** How many tasks are told. */
const SHOWN = 5;
/** What the trace lays around every task. */
const WRAPPERS = new Set(["RunTask", "ThreadControllerImpl::RunTask", "ThreadPool_RunTask"]);
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];

/** @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur: number, args: { name?: string } }} Event of a trace, times in µs */

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
  // Half a second more, in which the face is stored for the next visit.
  await visitor.frames(30);
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const tasks = mainThreadTasks(traceEvents);
  for (const { took_ms, held } of tasks.slice(0, SHOWN)) console.log(`    ${took_ms.toFixed(1)} ms: ${held}`);
  const [longest] = tasks;
  assert.ok(longest && longest.took_ms <= LONG_TASK_MS, `a task took ${longest?.took_ms.toFixed(0)} ms`);
});

/**
 * The tasks of the page's main thread, the longest first, by processor time, so that what else the machine does is left
 * out; with what took the most in each.
 *
 * @param {Event[]} events
 */
function mainThreadTasks(events) {
  const threads = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(threads.map(({ pid, tid }) => `${pid}:${tid}`));
  const timed = events.filter(({ ph, pid, tid, tdur }) => ph === "X" && tdur && main.has(`${pid}:${tid}`));
  const tasks = timed.filter(({ name }) => name === "RunTask").sort((a, b) => b.tdur - a.tdur);
  return tasks.map((task) => ({ took_ms: task.tdur / 1000, held: partsOf(task, timed) }));
}

/**
 * What a task held, as the browser's own trace names it.
 *
 * @param {Event} task
 * @param {Event[]} events
 */
function partsOf(task, events) {
  const within = events.filter(({ ts, dur, tid, name }) =>
    tid === task.tid && ts >= task.ts && ts + dur <= task.ts + task.dur && !WRAPPERS.has(name));
  const longest = within.sort((a, b) => b.tdur - a.tdur).slice(0, 3);
  return longest.map(({ name, tdur }) => `${name} ${(tdur / 1000).toFixed(1)}`).join(", ");
}
