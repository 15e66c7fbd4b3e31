// What the browser's own trace says of the page's main thread.

/** What the trace lays around every task. */
const WRAPPERS = new Set(["RunTask", "ThreadControllerImpl::RunTask", "ThreadPool_RunTask"]);
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline"];

/** @typedef {{ name: string, ph: string, pid: number, tid: number, ts: number, dur: number, tdur: number, args: { name?: string } }} Event of a trace, times in µs */

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
  const timed = onMainThread(events);
  const tasks = timed.filter(({ name }) => name === "RunTask").sort((a, b) => b.tdur - a.tdur);
  return tasks.map((task) => ({ took_ms: task.tdur / 1000, held: partsOf(task, timed) }));
}

/** How the page's own script comes to run. */
const ENTRIES = new Set(["EventDispatch", "FunctionCall", "FireAnimationFrame", "TimerFire", "RunMicrotasks"]);

/**
 * Processor time in ms that the page's script took on its main thread, without what the browser does besides, such as painting.
 *
 * @param {Event[]} events
 */
export function scriptTime(events) {
  const entries = onMainThread(events).filter(({ name }) => ENTRIES.has(name)).sort((a, b) => a.ts - b.ts || b.dur - a.dur);
  let [sum, until] = [0, -Infinity];
  for (const { ts, dur, tdur } of entries) {
    if (ts < until) continue;
    sum += tdur;
    until = ts + dur;
  }
  return sum / 1000;
}

/** @param {Event[]} events */
function onMainThread(events) {
  const threads = events.filter(({ name, args }) => name === "thread_name" && args.name === "CrRendererMain");
  const main = new Set(threads.map(({ pid, tid }) => `${pid}:${tid}`));
  return events.filter(({ ph, pid, tid, tdur }) => ph === "X" && tdur && main.has(`${pid}:${tid}`));
}

/** What a task held, as the browser's own trace names it. @param {Event} task @param {Event[]} events */
function partsOf(task, events) {
  const within = events.filter(({ ts, dur, tid, name }) =>
    tid === task.tid && ts >= task.ts && ts + dur <= task.ts + task.dur && !WRAPPERS.has(name));
  const longest = within.sort((a, b) => b.tdur - a.tdur).slice(0, 3);
  return longest.map(({ name, tdur }) => `${name} ${(tdur / 1000).toFixed(1)}`).join(", ");
}
