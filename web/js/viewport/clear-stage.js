/** @typedef {import("./workbench.js").Workbench} Workbench */

/** What lies over the stage for longer than a moment, at its upper and its lower edge. */
const ABOVE = ["faces"];
const BELOW = ["toolbar", "hint"];

/** What is framed keeps this far from them, in CSS px. */
const MARGIN_PX = 8;

/**
 * Has the face framed in what nothing lies over, and framed again when that changes.
 *
 * @param {Workbench} bench
 */
export function keepStageClear(bench) {
  const tell = () => {
    const stage = bench.canvas.getBoundingClientRect();
    const lowest = Math.max(stage.top, ...boxesOf(ABOVE).map(({ bottom }) => bottom + MARGIN_PX));
    const highest = Math.min(stage.bottom, ...boxesOf(BELOW).map(({ top }) => top - MARGIN_PX));
    const ratio = devicePixelRatio;
    bench.act((studio) => studio.cover((lowest - stage.top) * ratio, 0, (stage.bottom - highest) * ratio, 0));
  };
  const observer = new ResizeObserver(tell);
  for (const element of [bench.canvas, ...ABOVE.concat(BELOW).map((id) => document.getElementById(id))]) {
    if (element) observer.observe(element);
  }
  bench.onRestart(async () => tell());
}

/**
 * The boxes of those that are seen.
 *
 * @param {string[]} ids
 */
function boxesOf(ids) {
  const elements = ids.map((id) => document.getElementById(id));
  return elements.filter((element) => element?.checkVisibility()).map((element) => /** @type {HTMLElement} */ (element).getBoundingClientRect());
}
