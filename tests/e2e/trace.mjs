// What the browser's own trace says of the page's main thread.

/** What the trace lays around every task. */
const WRAPPERS = new Set(["RunTask", "ThreadControllerImpl::RunTask", "ThreadPool_RunTask"]);
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];

/**
 * @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur: number, args: { name?: string } }} Event
 *   of a trace, times in µs
 */

/**
 * The events of a trace while something is done.
 *
 * @param {import("@playwright/test").Page} page
 * @param {() => Promise<void>} act
 * @returns {Promise<Event[]>}
 */
export async function traced(page, act) {
  const browser = page.context().browser();
  await browser.startTracing(page, { categories: CATEGORIES });
  await act();
  return JSON.parse((await browser.stopTracing()).toString()).traceEvents;
}

/**
 * The tasks of the page's main thread, the longest first, by processor time, so that what else the machine does is left
 * out; with what took the most in each.
 *
 * @param {Event[]} events
 */
export function mainThreadTasks(events) {
  const threads = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(threads.map(({ pid, tid }) => `${pid}:${tid}`));
  const timed = events.filter(({ ph, pid, tid, tdur }) => ph === "X" && tdur && main.has(`${pid}:${tid}`));
  timed.sort((a, b) => b.tdur - a.tdur);
  const tasks = timed.filter(({ name }) => name === "RunTask");
  return tasks.map((task) => ({ took_ms: task.tdur / 1000, held: partsOf(task, timed) }));
}

/** What a task held, as the browser's own trace names it. @param {Event} task @param {Event[]} events the longest first */
function partsOf(task, events) {
  const within = events.filter(({ ts, dur, tid, name }) =>
    tid === task.tid && ts >= task.ts && ts + dur <= task.ts + task.dur && !WRAPPERS.has(name));
  return within.slice(0, 3).map(({ name, tdur }) => `${name} ${(tdur / 1000).toFixed(1)}`).join(", ");
}
