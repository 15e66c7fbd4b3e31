// How long a slider's tick keeps the page's thread, all in: from the input event to the end of the last listener, on the
// page itself in headless Chrome, with as many entries in the history as an afternoon leaves there.
import { launch } from "../journeys/browser.mjs";
import { DIST, serve } from "../journeys/server.mjs";
import { Visitor } from "../journeys/visitor.mjs";
import { report } from "./blank-page.mjs";

const ENTRIES = 40;
const LOOKS = 60;
/** A real mouse moves once for each frame. */
const DRAG_LOOKS = 12;
/** The browser's clock is coarse: so many events between two looks at it. */
const EVENTS = 20;

const browser = await launch();
const server = await serve(DIST, "/");
try {
  const visitor = await Visitor.arrive(browser, server.url);
  const { page } = visitor;
  await visitor.dropSample();
  await page.evaluate(edit, ENTRIES);
  for (const [density, vertices] of [["0", 468], ["3", 28_881]]) {
    await page.selectOption("#density", density, { force: true });
    await visitor.frames(5);
    const { entries, times_ms } = await page.evaluate(tick, { LOOKS, EVENTS });
    if (entries < ENTRIES) throw new Error(`${entries} entries, not ${ENTRIES}`);
    report({ task: "tick-listeners", peer: "rosto in Chrome", vertices }, times_ms);
    report({ task: "drag-listeners", peer: "rosto in Chrome", vertices }, await drag(visitor));
  }
} finally {
  await browser.close();
  server.close();
}

/** A landmark is dragged by the mouse; each look is the mean of the moves between two looks at the clock. */
async function drag(visitor) {
  const { page } = visitor;
  await visitor.findLandmark("nose tip");
  const tip = await visitor.tagged();
  await page.evaluate(watchMoves);
  await page.mouse.move(tip.x, tip.y);
  await page.mouse.down();
  const times_ms = [];
  for (let look = 0; look < DRAG_LOOKS; look += 1) {
    for (let step = 1; step <= 5; step += 1) await page.mouse.move(tip.x, tip.y - 5 - ((look + step) % 30));
    times_ms.push(await page.evaluate(() => globalThis.meanMove_ms()));
  }
  await page.keyboard.press("Escape");
  await page.mouse.up();
  return times_ms;
}

/** Runs in the browser: times every move of the pointer from before the first listener to behind the last. */
function watchMoves() {
  let [start, spent_ms, moves] = [0, 0, 0];
  addEventListener("pointermove", () => (start = performance.now()), { capture: true });
  addEventListener("pointermove", () => {
    spent_ms += performance.now() - start;
    moves += 1;
  });
  globalThis.meanMove_ms = () => {
    const mean_ms = spent_ms / Math.max(1, moves);
    [spent_ms, moves] = [0, 0];
    return mean_ms;
  };
}

/** Runs in the browser: as many edits as asked for, each of another landmark. */
function edit(count) {
  const search = document.getElementById("landmark-search");
  for (let entry = 0; entry < count; entry += 1) {
    search.value = String(11 * entry + 1);
    search.dispatchEvent(new Event("change", { bubbles: true }));
    const number = document.querySelector("#landmark-sliders [data-axis='z'] input[type=number]");
    number.value = "0.5";
    number.dispatchEvent(new Event("input", { bubbles: true }));
    number.dispatchEvent(new Event("change", { bubbles: true }));
  }
}

/** Runs in the browser: ticks of one slider; the listeners of an event have run when it is dispatched. */
async function tick({ LOOKS, EVENTS }) {
  const range = document.querySelector("#landmark-sliders [data-axis='z'] input[type=range]");
  const times_ms = [];
  for (let look = 0; look < LOOKS; look += 1) {
    await new Promise(requestAnimationFrame);
    const start = performance.now();
    for (let event = 0; event < EVENTS; event += 1) {
      range.value = String((look + event) / 10);
      range.dispatchEvent(new Event("input", { bubbles: true }));
    }
    times_ms.push((performance.now() - start) / EVENTS);
  }
  const entries = document.querySelectorAll("#history li").length;
  return { entries, times_ms };
}
