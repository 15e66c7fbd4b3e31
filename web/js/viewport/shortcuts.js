import { isTyping } from "../../src/dom.ts";

/** @typedef {import("./host.js").Host} Host */

/** Drag distance that corresponds to one press of an arrow key, in CSS px. */
const STEP_PX = 24;
const ZOOM_STEP = 1.1;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * Sets up the keys of the 3D view, active while the canvas has the focus.
 *
 * @param {Host} host
 * @param {(action: "turn") => void} [onGesture]
 */
export function setUpViewKeys(host, onGesture) {
  host.canvas.addEventListener("keydown", (event) => {
    if (moveByArrow(host, event, onGesture) || chooseView(host, event) || clearSelection(host, event)) event.preventDefault();
  });
}

/**
 * Sets up undo and redo on the whole page, except while typing.
 *
 * @param {{ undo: () => void, redo: () => void, cancel: () => void }} actions
 */
export function setUpEditKeys(actions) {
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

/**
 * @param {Host} host
 * @param {KeyboardEvent} event
 * @param {(action: "turn") => void} [onGesture]
 */
function moveByArrow(host, event, onGesture) {
  const arrow = ARROWS[event.key];
  if (!arrow) return false;
  const [x, y] = arrow;
  /** @type {[number, number]} */
  const by_px = [x * STEP_PX * devicePixelRatio, y * STEP_PX * devicePixelRatio];
  if (event.altKey) host.apply({ zoom: y < 0 ? ZOOM_STEP : 1 / ZOOM_STEP });
  else if (event.shiftKey && (event.ctrlKey || event.metaKey)) host.apply({ pan: by_px });
  else {
    onGesture?.("turn");
    host.apply({ orbit: by_px });
  }
  return true;
}

/**
 * @param {Host} host
 * @param {KeyboardEvent} event
 */
function chooseView(host, event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const views = /** @type {const} */ ({ f: "front", l: "left", t: "top", " ": "reset" });
  const key = event.key.toLowerCase();
  if (key === "w") host.applyShown({ set: ["view.wireframe", !host.read(({ wireframe }) => wireframe)] });
  if (!(key in views)) return false;
  host.apply({ "go-to": views[/** @type {keyof typeof views} */ (key)] });
  return true;
}

/**
 * Escape clears the selection. During a drag, it cancels the drag instead.
 *
 * @param {Host} host
 * @param {KeyboardEvent} event
 */
function clearSelection(host, event) {
  if (event.key !== "Escape") return false;
  host.apply({ select: undefined });
  return true;
}
