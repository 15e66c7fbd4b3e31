/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {"x" | "y" | "z"} AxisName
 * @typedef {{ x: number, y: number, button: number }} Press in CSS px of the window
 * @typedef {{ x: number, y: number, apart: number }} Spread centre and distance of the fingers, in CSS px
 *
 * @typedef {object} GestureListener positions in device pixels of the canvas
 * @property {(x_px: number, y_px: number) => void} hover
 * @property {() => void} leave
 * @property {() => void} press
 * @property {() => void} radiusChanged
 * @property {(action: "drag" | "turn") => void} gesture
 */

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

const AXIS_KEYS = /** @type {Record<string, AxisName>} */ ({ x: "x", y: "y", z: "z" });

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
  /** @type {Map<number, Press>} */
  #pressed = new Map();
  /** Whether the press can still become a click. */
  #mayClick = false;
  #moved_px = 0;
  /** Pointer that drags a point. @type {number | undefined} */
  #grabPointer;
  #isDragging = false;
  /** Axis to which the drag is restricted. @type {string | undefined} */
  #along;
  /** Unrounded influence radius; one pinch step can change it by less than 1 mm. */
  #radius_mm = 0;
  #host;
  #listener;

  /**
   * @param {Host} host
   * @param {GestureListener} listener
   */
  constructor(host, listener) {
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

  /** @param {PointerEvent} event */
  #press(event) {
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

  /** @param {PointerEvent} event */
  #move(event) {
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

  /** @param {PointerEvent} event */
  #release(event) {
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

  /** @param {PointerEvent} event */
  #cancel(event) {
    this.#pressed.delete(event.pointerId);
    this.#mayClick = false;
    if (this.#isDragging) this.#host.apply("cancel");
    this.#endGrab();
  }

  #endGrab() {
    this.#grabPointer = undefined;
    this.#host.apply("release");
  }

  /** Grabs the point under the pointer, if there is one. @param {PointerEvent} event */
  #grab(event) {
    const applied = this.#host.apply({ press: [this.#position(event), event.pointerType === "touch"] });
    if (applied?.hasGrabbed) this.#grabPointer = event.pointerId;
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    this.#host.apply({ drag: [this.#position(event), event.shiftKey] });
    this.#listener.gesture("drag");
  }

  /** While dragging, X, Y and Z restrict the axis and Escape cancels. @param {KeyboardEvent} event */
  #key(event) {
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

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (this.#isDragging) this.#scaleRadius(1 / factor);
    else this.#host.apply({ zoom: factor });
  }

  /** @param {number} factor scale of the influence radius */
  #scaleRadius(factor) {
    if (!Number.isFinite(factor) || factor <= 0) return;
    const { min, max } = this.#host.catalogue.radius;
    this.#radius_mm = Math.min(max, Math.max(min, this.#radius_mm * factor));
    this.#host.apply({ radius: Math.round(this.#radius_mm) });
    this.#listener.radiusChanged();
  }

  /**
   * @param {number} dx in CSS px
   * @param {number} dy
   * @param {boolean} moves pan instead of turn
   */
  #turn(dx, dy, moves) {
    /** @type {[number, number]} */
    const by_px = [dx * devicePixelRatio, dy * devicePixelRatio];
    this.#host.apply(moves ? { pan: by_px } : { orbit: by_px });
    if (!moves) this.#listener.gesture("turn");
  }

  /**
   * @param {Spread} before
   * @param {Spread} after
   */
  #pinch(before, after) {
    this.#turn(after.x - before.x, after.y - before.y, this.#pressed.size > 2);
    if (before.apart > 0 && after.apart > 0) this.#host.apply({ zoom: after.apart / before.apart });
  }

  /**
   * Pointer position in device pixels of the canvas.
   *
   * @param {PointerEvent} event
   * @returns {[number, number]}
   */
  #position(event) {
    const { canvas } = this.#host;
    const box = canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) * canvas.width) / box.width,
      ((event.clientY - box.top) * canvas.height) / box.height,
    ];
  }
}

/**
 * Centre of all fingers and distance of the first two.
 *
 * @param {Map<number, Press>} pressed
 * @returns {Spread}
 */
function spreadOf(pressed) {
  const presses = [...pressed.values()];
  const [first = { x: 0, y: 0 }, second = first] = presses;
  const mean = (/** @type {"x" | "y"} */ along) => presses.reduce((sum, press) => sum + press[along], 0) / presses.length;
  return { x: mean("x"), y: mean("y"), apart: Math.hypot(first.x - second.x, first.y - second.y) };
}
