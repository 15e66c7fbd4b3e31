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
  let isWanted = false;
  let isSelected = false;
  const show = () => {
    dot.hidden = !isWanted || isSelected;
    place();
  };
  onHint((deed) => {
    isWanted = deed === "drag";
    show();
  });
  // What is selected has a mark of its own.
  bench.onChange(({ selected }) => {
    isSelected = selected !== undefined;
    show();
  });
  bench.onFrame(place);
}
