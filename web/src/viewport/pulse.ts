import { byId } from "../page/dom.ts";
import { onHint } from "../page/hint.ts";
import type { Host } from "./host.ts";

/** The landmark that the first hint suggests dragging. */
const NOSE_TIP = 1;

/** Shows a pulsing dot on the nose until the user has dragged something. */
export function setUpPulse(host: Host) {
  const dot = byId("pulse", HTMLSpanElement);
  const place = () => {
    if (dot.hidden) return;
    const at = host.ask((studio) => studio.screenPosition(NOSE_TIP));
    if (!at) return;
    const [x = 0, y = 0] = at;
    dot.style.translate = `${x / devicePixelRatio}px ${y / devicePixelRatio}px`;
  };
  let isWanted = false;
  let isSelected = false;
  const show = () => {
    dot.hidden = !isWanted || isSelected;
    place();
  };
  onHint((action) => {
    isWanted = action === "drag";
    show();
  });
  // The selection has its own marker.
  host.on("change", ({ selected }) => {
    isSelected = selected !== undefined;
    show();
  });
  host.on("frame", place);
}
