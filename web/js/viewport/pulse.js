import { byId } from "../page/dom.js";
import { onHint } from "../page/hint.js";

/** @typedef {import("./workbench.js").Workbench} Workbench */

/** The landmark that a newcomer is told to drag. */
const NOSE_TIP = 1;

/**
 * A dot that pulses where to drag, until something was dragged.
 *
 * @param {Workbench} bench
 */
export function setUpPulse(bench) {
  const dot = byId("pulse", HTMLSpanElement);
  const place = () => {
    if (dot.hidden) return;
    const at = bench.ask((studio) => studio.screenPosition(NOSE_TIP));
    if (!at) return;
    dot.style.translate = `${at.x / devicePixelRatio}px ${at.y / devicePixelRatio}px`;
    at.free();
  };
  onHint((deed) => {
    dot.hidden = deed !== "drag";
    place();
  });
  bench.onFrame(place);
}
