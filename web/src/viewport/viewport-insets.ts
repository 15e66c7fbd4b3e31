import { byId } from "../page/dom.ts";
import type { Host } from "./host.ts";

/** Elements that stay over the stage. */
const OVERLAY_IDS = ["faces", "privacy", "toolbar", "hint", "live"];

/** Distance between the face and these elements, in CSS px. */
const MARGIN_PX = 8;

/** Updates the viewport insets, so that the face is framed in the uncovered part of the stage. */
export function setUpViewportInsets(host: Host) {
  const photoPane = byId("photo-pane", HTMLButtonElement);
  const apply = () => {
    const stage = host.canvas.getBoundingClientRect();
    const isAbove = ({ top, bottom }: DOMRect) => top + bottom < stage.top + stage.bottom;
    const overlays = visibleOverlays().map((overlay) => overlay.getBoundingClientRect());
    const lowest = Math.max(stage.top, ...overlays.filter(isAbove).map(({ bottom }) => bottom + MARGIN_PX));
    const highest = Math.min(stage.bottom, ...overlays.filter((box) => !isAbove(box)).map(({ top }) => top - MARGIN_PX));
    const { right } = photoPane.getBoundingClientRect();
    const left = photoPane.hidden ? 0 : right - stage.left;
    const sides = [lowest - stage.top, 0, stage.bottom - highest, left].map((side) => side * devicePixelRatio);
    const [above = 0, after = 0, below = 0, before = 0] = sides;
    host.apply({ "viewport-insets": [above, after, below, before] });
  };
  const observer = new ResizeObserver(apply);
  for (const element of [host.canvas, photoPane, ...overlays()]) observer.observe(element);
  host.onRestart(async () => apply());
}

function overlays() {
  return OVERLAY_IDS.map((id) => byId(id, HTMLElement));
}

function visibleOverlays() {
  return overlays().filter((overlay) => overlay.checkVisibility());
}
