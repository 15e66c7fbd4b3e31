import { isComposing } from "../page/dom.ts";
import type { Host } from "./host.ts";

type Point = { x: number; y: number };

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

/** Time and distance within which two taps are a double tap. */
const DOUBLE_TAP_MS = 350;
const DOUBLE_TAP_PX = 24;

/** A wheel notch zooms by about 10%. */
const ZOOM_PER_WHEEL_PX = 0.001;
const LINE_PX = 16;

/**
 * Translates pointer events on the canvas into intents:
 *
 * - Drag a highlighted point: move it. Wheel or second finger meanwhile: change the influence radius.
 * - Drag elsewhere, or with another button: turn the face or pan the photo; with Shift: pan.
 * - Two fingers: turn or pan, and zoom. Three fingers: pan. Wheel: zoom.
 * - Click: select; with Alt: pin. Double tap, or double click next to the face: fit.
 *
 * @param onTurn called when the face is turned
 */
export function setUpGestures(host: Host, onTurn = () => {}) {
  const { canvas } = host;
  /** Positions of the pressed pointers, in CSS px. */
  const pressed = new Map<number, Point>();
  /** Position of a press that can still become a click. */
  let click_px: [number, number] | undefined;
  let moved_px = 0;
  let isPhoto = false;
  /** The last tap: its time and position in CSS px. */
  let tap = { time_ms: Number.NEGATIVE_INFINITY, x: 0, y: 0 };
  /** Pointer that drags a point. */
  let grabPointer: number | undefined;
  let isDragging = false;
  /** Axis to which the drag is restricted. */
  let along: string | undefined;
  /** Unrounded influence radius; one pinch step can change it by less than 1 mm. */
  let radius_mm = 0;
  /** Pointer position over the view while nothing is pressed. */
  let pointer_px: [number, number] | undefined;
  /** The point under the pointer. */
  let hovered: number | undefined;

  /** Pointer position in device pixels of the canvas. */
  const positionOf = ({ clientX, clientY }: { clientX: number; clientY: number }): [number, number] => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    return [((clientX - left) * canvas.width) / width, ((clientY - top) * canvas.height) / height];
  };
  const hover = (position_px: [number, number] | undefined) => {
    pointer_px = position_px;
    host.apply({ hover: position_px });
  };
  const scaleRadius = (factor: number) => {
    if (!Number.isFinite(factor) || factor <= 0) return;
    const { min, max } = host.catalogue.radius;
    radius_mm = Math.min(max, Math.max(min, radius_mm * factor));
    host.apply({ radius: Math.round(radius_mm) });
  };
  /** Turns by CSS px, or pans. */
  const turn = (dx: number, dy: number, moves: boolean) => {
    const by_px: [number, number] = [dx * devicePixelRatio, dy * devicePixelRatio];
    host.apply(moves ? { pan: by_px } : { orbit: by_px });
    if (!moves && !isPhoto) onTurn();
  };
  const endGrab = () => {
    grabPointer = undefined;
    host.apply("release");
  };

  const press = (event: PointerEvent) => {
    canvas.setPointerCapture(event.pointerId);
    pointer_px = undefined;
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY });
    click_px = pressed.size === 1 && event.button === 0 ? positionOf(event) : undefined;
    if (pressed.size > 1) {
      // A drag continues with the first finger.
      if (!isDragging) endGrab();
      return;
    }
    moved_px = 0;
    const applied = click_px && host.apply({ press: [click_px, event.pointerType === "touch"] });
    grabPointer = applied?.hasGrabbed ? event.pointerId : undefined;
  };
  const move = (event: PointerEvent) => {
    const from = pressed.get(event.pointerId);
    if (!from) return hover(positionOf(event));
    const before = spreadOf(pressed);
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const after = spreadOf(pressed);
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    moved_px += Math.hypot(dx, dy);
    if (moved_px < CLICK_SLOP_PX) return;
    click_px = undefined;
    if (grabPointer === event.pointerId) {
      host.apply({ drag: [positionOf(event), event.shiftKey] });
    } else if (grabPointer !== undefined) scaleRadius(after.apart / before.apart);
    else if (pressed.size === 1) turn(dx, dy, event.shiftKey);
    else {
      turn(after.x - before.x, after.y - before.y, pressed.size > 2);
      if (before.apart > 0 && after.apart > 0) host.apply({ "zoom-at": [after.apart / before.apart, positionOf({ clientX: after.x, clientY: after.y })] });
    }
  };
  /** Fits the view, or selects. A mouse fits it next to the face, because repeated clicks select larger regions. */
  const click = ({ pointerType, timeStamp, clientX: x, clientY: y, altKey }: PointerEvent, at_px: [number, number]) => {
    const isNear = Math.hypot(x - tap.x, y - tap.y) < DOUBLE_TAP_PX && timeStamp - tap.time_ms < DOUBLE_TAP_MS;
    const fits = isNear && (pointerType === "touch" || hovered === undefined);
    tap = fits ? { time_ms: Number.NEGATIVE_INFINITY, x, y } : { time_ms: timeStamp, x, y };
    if (fits) host.apply({ "go-to": "reset" });
    else host.apply(altKey ? { "pin-under": at_px } : { "select-under": at_px });
  };
  const release = (event: PointerEvent) => {
    pressed.delete(event.pointerId);
    const at_px = click_px;
    click_px = undefined;
    // Ends a change of the radius; the drag continues.
    if (grabPointer !== undefined && grabPointer !== event.pointerId) return;
    if (event.type === "pointercancel") host.apply("cancel");
    endGrab();
    if (at_px && event.type === "pointerup") click(event, at_px);
    // A mouse stays where it is; a finger is gone.
    if (event.pointerType !== "touch") hover(positionOf(event));
  };
  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * LINE_PX : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (isDragging) scaleRadius(1 / factor);
    else host.apply({ "zoom-at": [factor, positionOf(event)] });
  };
  /** While dragging, X, Y and Z restrict the axis and Escape cancels. */
  const key = (event: KeyboardEvent) => {
    if (!isDragging || event.ctrlKey || event.metaKey || isComposing(event)) return;
    const axis = event.key.toLowerCase();
    if (event.key === "Escape") {
      event.stopPropagation();
      host.apply("cancel");
    } else if (["x", "y", "z"].includes(axis)) {
      event.preventDefault();
      // The same axis again lifts the restriction.
      host.apply({ along: axis === along ? undefined : axis });
    }
  };

  host.on("change", (state) => {
    isDragging = state.isDragging;
    isPhoto = state.chosen["scene"] === "picture";
    if (Math.round(radius_mm) !== state.radiusMm) radius_mm = state.radiusMm;
  });
  host.on("tick", (tick) => (along = tick.along));
  host.on("applied", (applied) => {
    hovered = applied.hovered;
    if (pressed.size === 0) canvas.classList.toggle("over-landmark", hovered !== undefined);
  });
  host.on("frame", () => {
    const at_px = pointer_px;
    // The face may have moved under a resting pointer. Without `apply`, which would request a frame each time.
    if (at_px && host.ask((studio) => studio.apply({ hover: at_px }))?.hovered !== hovered) hover(at_px);
  });
  canvas.addEventListener("pointerdown", press);
  canvas.addEventListener("pointermove", move);
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => hover(undefined));
  canvas.addEventListener("wheel", wheel, { passive: false });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  // The middle button scrolls by the first event and, under Linux, pastes by the others.
  for (const name of ["mousedown", "mouseup", "auxclick"] as const) {
    canvas.addEventListener(name, (event) => event.button === 1 && event.preventDefault());
  }
  addEventListener("keydown", key, { capture: true, signal: host.closed });
}

/** Centre of all fingers and distance of the first two. */
function spreadOf(pressed: Map<number, Point>) {
  const points = [...pressed.values()];
  const [first = { x: 0, y: 0 }, second = first] = points;
  const mean = (along: "x" | "y") => points.reduce((sum, point) => sum + point[along], 0) / points.length;
  return { x: mean("x"), y: mean("y"), apart: Math.hypot(first.x - second.x, first.y - second.y) };
}
