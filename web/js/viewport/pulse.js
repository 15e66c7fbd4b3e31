import { byId } from "../page/dom.js";
import { onHint } from "../page/hint.js";

/** @typedef {import("./host.js").Host} Host */

/** The landmark that a newcomer is told to drag. */
const NOSE_TIP = 1;

/**
 * A dot that pulses where to drag, until something was dragged.
 *
 * @param {Host} host
 */
export function setUpPulse(host) {
  const dot = byId("pulse", HTMLSpanElement);
  const place = () => {
    if (dot.hidden) return;
    const at = host.ask((studio) => studio.screenPosition(NOSE_TIP));
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
  host.onChange(({ selected }) => {
    isSelected = selected !== undefined;
    show();
  });
  host.onFrame(place);
}
