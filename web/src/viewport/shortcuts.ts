import { isTyping } from "../page/dom.ts";
import type { Host } from "./host.ts";

/** Drag distance that corresponds to one press of an arrow key, in CSS px. */
const STEP_PX = 24;
const ZOOM_STEP = 1.1;

const ARROWS: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** Sets up the keys of the 3D view, active while the canvas has the focus. */
export function setUpViewKeys(host: Host, onGesture?: (action: "turn") => void) {
  host.canvas.addEventListener("keydown", (event) => {
    if (moveByArrow(host, event, onGesture) || chooseView(host, event) || clearSelection(host, event)) event.preventDefault();
  });
}

/** Sets up undo and redo on the whole page, except while typing. */
export function setUpEditKeys(actions: { undo: () => void; redo: () => void; cancel: () => void; }) {
  addEventListener("keydown", (event) => {
    if (event.isComposing) return;
    if (event.key === "Escape") return actions.cancel();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event)) return;
    const key = event.key.toLowerCase();
    if (key !== "z" && key !== "y") return;
    event.preventDefault();
    if (key === "y" || event.shiftKey) actions.redo();
    else actions.undo();
  });
}

function moveByArrow(host: Host, event: KeyboardEvent, onGesture?: (action: "turn") => void) {
  const arrow = ARROWS[event.key];
  if (!arrow) return false;
  const [x, y] = arrow;
  const by_px: [number, number] = [x * STEP_PX * devicePixelRatio, y * STEP_PX * devicePixelRatio];
  if (event.altKey) host.apply({ zoom: y < 0 ? ZOOM_STEP : 1 / ZOOM_STEP });
  else if (event.shiftKey && (event.ctrlKey || event.metaKey)) host.apply({ pan: by_px });
  else {
    onGesture?.("turn");
    host.apply({ orbit: by_px });
  }
  return true;
}

function chooseView(host: Host, event: KeyboardEvent) {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const views = ({ f: "front", l: "left", t: "top", " ": "reset" } as const);
  const key = event.key.toLowerCase();
  if (key === "w") host.applyShown({ set: ["view.wireframe", !host.read(({ wireframe }) => wireframe)] });
  if (!(key in views)) return false;
  host.apply({ "go-to": views[(key as keyof typeof views)] });
  return true;
}

/** Escape clears the selection. During a drag, it cancels the drag instead. */
function clearSelection(host: Host, event: KeyboardEvent) {
  if (event.key !== "Escape") return false;
  host.apply({ select: undefined });
  return true;
}
