import type { Host } from "./host.ts";

export type AxisName = "x" | "y" | "z";

export type Press = { x: number; y: number; button: number; };

export type Spread = { x: number; y: number; apart: number; };

export interface GestureListener {
  hover: (x_px: number, y_px: number) => void;
  leave: () => void;
  press: () => void;
  radiusChanged: () => void;
  gesture: (action: "drag" | "turn") => void;
}

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

const AXIS_KEYS = ({ x: "x", y: "y", z: "z" } as Record<string, AxisName>);

/** A wheel notch zooms by about 10%. */
const ZOOM_PER_WHEEL_PX = 0.001;

/**
 * Translates pointer events on the canvas into intents:
 *
 * - Drag a highlighted point: move it. Wheel or second finger meanwhile: change the influence radius.
 * - Drag elsewhere, or with another button: turn; with Shift: pan.
 * - Two fingers: turn and zoom. Three fingers: pan. Wheel: zoom.
 * - Click: select; with Alt: pin.
 */
export class Gestures {
  #pressed: Map<number, Press> = new Map();
  /** Whether the press can still become a click. */
  #mayClick = false;
  #moved_px = 0;
  /** Pointer that drags a point. */
  #grabPointer: number | undefined;
  #isDragging = false;
  /** Axis to which the drag is restricted. */
  #along: string | undefined;
  /** Unrounded influence radius; one pinch step can change it by less than 1 mm. */
  #radius_mm = 0;
  #host;
  #listener;

  constructor(host: Host, listener: GestureListener) {
    this.#host = host;
    this.#listener = listener;
    const { canvas } = host;
    host.onChange(({ isDragging, radiusMm }) => {
      this.#isDragging = isDragging;
      if (Math.round(this.#radius_mm) !== radiusMm) this.#radius_mm = radiusMm;
    });
    host.onTick(({ along }) => (this.#along = along));
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#cancel(event));
    canvas.addEventListener("pointerleave", () => listener.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    // Prevents autoscroll.
    canvas.addEventListener("mousedown", (event) => event.button === 1 && event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    addEventListener("keydown", (event) => this.#key(event), { capture: true, signal: host.closed });
  }

  #press(event: PointerEvent) {
    this.#host.canvas.setPointerCapture(event.pointerId);
    this.#listener.press();
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: event.button });
    this.#mayClick = this.#pressed.size === 1 && event.button === 0;
    // A drag continues with the first finger.
    if (this.#pressed.size > 1) return this.#isDragging ? undefined : this.#endGrab();
    this.#moved_px = 0;
    this.#grabPointer = undefined;
    if (event.button === 0) this.#grab(event);
  }

  #move(event: PointerEvent) {
    const from = this.#pressed.get(event.pointerId);
    if (!from) return this.#listener.hover(...this.#position(event));
    const before = spreadOf(this.#pressed);
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: from.button });
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    this.#moved_px += Math.hypot(dx, dy);
    if (this.#moved_px < CLICK_SLOP_PX) return;
    this.#mayClick = false;
    const after = spreadOf(this.#pressed);
    if (this.#grabPointer === event.pointerId) this.#drag(event);
    else if (this.#grabPointer !== undefined) this.#scaleRadius(after.apart / before.apart);
    else if (this.#pressed.size > 1) this.#pinch(before, after);
    else this.#turn(dx, dy, event.shiftKey);
  }

  #release(event: PointerEvent) {
    this.#pressed.delete(event.pointerId);
    const isClick = this.#mayClick;
    this.#mayClick = false;
    // Ends a change of the radius; the drag continues.
    if (this.#grabPointer !== undefined && this.#grabPointer !== event.pointerId) return;
    this.#grabPointer = undefined;
    this.#host.apply("release");
    const place = this.#position(event);
    if (isClick) this.#host.apply(event.altKey ? { "pin-under": place } : { "select-under": place });
    // A mouse stays where it is; a finger is gone.
    if (event.pointerType !== "touch") this.#listener.hover(...place);
  }

  #cancel(event: PointerEvent) {
    this.#pressed.delete(event.pointerId);
    this.#mayClick = false;
    if (this.#isDragging) this.#host.apply("cancel");
    this.#endGrab();
  }

  #endGrab() {
    this.#grabPointer = undefined;
    this.#host.apply("release");
  }

  /** Grabs the point under the pointer, if there is one. */
  #grab(event: PointerEvent) {
    const applied = this.#host.apply({ press: [this.#position(event), event.pointerType === "touch"] });
    if (applied?.hasGrabbed) this.#grabPointer = event.pointerId;
  }

  #drag(event: PointerEvent) {
    this.#host.apply({ drag: [this.#position(event), event.shiftKey] });
    this.#listener.gesture("drag");
  }

  /** While dragging, X, Y and Z restrict the axis and Escape cancels. */
  #key(event: KeyboardEvent) {
    if (!this.#isDragging || event.ctrlKey || event.metaKey) return;
    const axis = AXIS_KEYS[event.key.toLowerCase()];
    if (event.key === "Escape") {
      event.stopPropagation();
      this.#host.apply("cancel");
    } else if (axis) {
      event.preventDefault();
      // The same axis again lifts the restriction.
      this.#host.apply({ along: axis === this.#along ? undefined : axis });
    }
  }

  #wheel(event: WheelEvent) {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (this.#isDragging) this.#scaleRadius(1 / factor);
    else this.#host.apply({ zoom: factor });
  }

  /** @param factor scale of the influence radius */
  #scaleRadius(factor: number) {
    if (!Number.isFinite(factor) || factor <= 0) return;
    const { min, max } = this.#host.catalogue.radius;
    this.#radius_mm = Math.min(max, Math.max(min, this.#radius_mm * factor));
    this.#host.apply({ radius: Math.round(this.#radius_mm) });
    this.#listener.radiusChanged();
  }

  /**
   * @param dx in CSS px
   * @param moves pan instead of turn
   */
  #turn(dx: number, dy: number, moves: boolean) {
    const by_px: [number, number] = [dx * devicePixelRatio, dy * devicePixelRatio];
    this.#host.apply(moves ? { pan: by_px } : { orbit: by_px });
    if (!moves) this.#listener.gesture("turn");
  }

  #pinch(before: Spread, after: Spread) {
    this.#turn(after.x - before.x, after.y - before.y, this.#pressed.size > 2);
    if (before.apart > 0 && after.apart > 0) this.#host.apply({ zoom: after.apart / before.apart });
  }

  /** Pointer position in device pixels of the canvas. */
  #position(event: PointerEvent): [number, number] {
    const { canvas } = this.#host;
    const box = canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) * canvas.width) / box.width,
      ((event.clientY - box.top) * canvas.height) / box.height,
    ];
  }
}

/** Centre of all fingers and distance of the first two. */
function spreadOf(pressed: Map<number, Press>): Spread {
  const presses = [...pressed.values()];
  const [first = { x: 0, y: 0 }, second = first] = presses;
  const mean = (along: "x" | "y") => presses.reduce((sum, press) => sum + press[along], 0) / presses.length;
  return { x: mean("x"), y: mean("y"), apart: Math.hypot(first.x - second.x, first.y - second.y) };
}
