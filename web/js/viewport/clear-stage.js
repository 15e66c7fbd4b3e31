import { byId } from "../page/dom.js";

/** @typedef {import("./host.js").Host} Host */

/** What lies over the stage for longer than a moment. */
const FLOATS = ["faces", "privacy", "toolbar", "hint", "live"];

/** What is framed keeps this far from them, in CSS px. */
const MARGIN_PX = 8;

/**
 * Has the face framed in what nothing lies over, and framed again when that changes.
 *
 * @param {Host} host
 */
export function keepStageClear(host) {
  const beside = byId("beside", HTMLButtonElement);
  const tell = () => {
    const stage = host.canvas.getBoundingClientRect();
    const isAbove = (/** @type {DOMRect} */ { top, bottom }) => top + bottom < stage.top + stage.bottom;
    const floats = floatsSeen().map((float) => float.getBoundingClientRect());
    const lowest = Math.max(stage.top, ...floats.filter(isAbove).map(({ bottom }) => bottom + MARGIN_PX));
    const highest = Math.min(stage.bottom, ...floats.filter((box) => !isAbove(box)).map(({ top }) => top - MARGIN_PX));
    const { right } = beside.getBoundingClientRect();
    const left = beside.hidden ? 0 : right - stage.left;
    const sides = [lowest - stage.top, 0, stage.bottom - highest, left].map((side) => side * devicePixelRatio);
    const [above = 0, after = 0, below = 0, before = 0] = sides;
    host.act((studio) => studio.setViewportInsets(above, after, below, before));
  };
  const observer = new ResizeObserver(tell);
  for (const element of [host.canvas, beside, ...floats()]) observer.observe(element);
  host.onRestart(async () => tell());
}

function floats() {
  return FLOATS.map((id) => byId(id, HTMLElement));
}

/** A line beside the tools takes nothing more away than they do. */
function floatsSeen() {
  return floats().filter((float) => float.checkVisibility());
}
