// Reads the browser's trace of the page's main thread.

/** Events that wrap each task. */
const WRAPPERS = new Set(["RunTask", "ThreadControllerImpl::RunTask", "ThreadPool_RunTask"]);
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];

/**
 * @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur: number, args: { name?: string } }} Event
 *   trace event, times in µs
 */

/**
 * Records a trace while `act` runs.
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
 * Tasks of the page's main thread, longest first, with their longest parts. Uses CPU time, which excludes other load.
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

/** Longest parts of a task. @param {Event} task @param {Event[]} events longest first */
function partsOf(task, events) {
  const within = events.filter(({ ts, dur, tid, name }) =>
    tid === task.tid && ts >= task.ts && ts + dur <= task.ts + task.dur && !WRAPPERS.has(name));
  return within.slice(0, 3).map(({ name, tdur }) => `${name} ${(tdur / 1000).toFixed(1)}`).join(", ");
}
