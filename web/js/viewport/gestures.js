/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {"x" | "y" | "z"} AxisName
 * @typedef {import("../../wasm/rosto-studio-web.js").PointerName} PointerName
 * @typedef {{ x: number, y: number, button: number }} Press in CSS px of the window
 * @typedef {{ x: number, y: number, apart: number }} Spread the fingers' middle and distance, in CSS px
 *
 * @typedef {object} Told places in device pixels of the canvas
 * @property {(x_px: number, y_px: number) => void} hover
 * @property {() => void} leave
 * @property {() => void} press what is hinted at from now on is what the press does
 * @property {() => void} widened
 * @property {(deed: "drag" | "turn") => void} did
 */

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

const AXIS_KEYS = /** @type {Record<string, AxisName>} */ ({ x: "x", y: "y", z: "z" });

/** One notch of a wheel zooms by about a tenth. */
const ZOOM_PER_WHEEL_PX = 0.001;

/**
 * Turns pointers on the canvas into intents. What lights up under the pointer is what a press takes and a drag moves; a drag
 * that starts beside the face, or with another button, turns it, and with Shift moves it. Two fingers turn, and zoom by
 * their distance; three move. The wheel zooms. While something is dragged, the wheel or a second finger changes how far that
 * reaches. A click picks, with Alt it pins.
 */
export class Gestures {
  /** @type {Map<number, Press>} */
  #pressed = new Map();
  /** Whether the press can still become a click. */
  #mayClick = false;
  #moved_px = 0;
  /** The pointer that has taken hold of something. @type {number | undefined} */
  #holder;
  #host;
  #told;

  /**
   * @param {Host} host
   * @param {Told} told
   */
  constructor(host, told) {
    this.#host = host;
    this.#told = told;
    const { canvas } = host;
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#lose(event));
    canvas.addEventListener("pointerleave", () => told.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    // The middle button would scroll the page.
    canvas.addEventListener("mousedown", (event) => event.button === 1 && event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    addEventListener("keydown", (event) => this.#key(event), { capture: true, signal: host.gone });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    this.#host.canvas.setPointerCapture(event.pointerId);
    this.#told.press();
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: event.button });
    this.#mayClick = this.#pressed.size === 1 && event.button === 0;
    // What is being dragged goes on under the first finger.
    if (this.#pressed.size > 1) return this.#isDragging ? undefined : this.#letGo();
    this.#moved_px = 0;
    this.#holder = undefined;
    if (event.button === 0) this.#take(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const from = this.#pressed.get(event.pointerId);
    if (!from) return this.#told.hover(...this.#place(event));
    const before = spreadOf(this.#pressed);
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: from.button });
    const [dx, dy] = [event.clientX - from.x, event.clientY - from.y];
    this.#moved_px += Math.hypot(dx, dy);
    if (this.#moved_px < CLICK_SLOP_PX) return;
    this.#mayClick = false;
    const after = spreadOf(this.#pressed);
    if (this.#holder === event.pointerId) this.#drag(event);
    else if (this.#holder !== undefined) this.#widen(after.apart / before.apart);
    else if (this.#pressed.size > 1) this.#pinch(before, after);
    else this.#turn(dx, dy, event.shiftKey);
  }

  /** @param {PointerEvent} event */
  #release(event) {
    this.#pressed.delete(event.pointerId);
    const isClick = this.#mayClick;
    this.#mayClick = false;
    // The finger that changed how far the drag reaches.
    if (this.#holder !== undefined && this.#holder !== event.pointerId) return;
    this.#holder = undefined;
    this.#host.act((studio) => studio.release());
    const place = this.#place(event);
    if (isClick) this.#host.act((studio) => (event.altKey ? studio.pinUnder(...place) : studio.selectUnder(...place)));
    // A mouse rests where it was let go; a finger is gone.
    if (event.pointerType !== "touch") this.#told.hover(...place);
  }

  /** @param {PointerEvent} event */
  #lose(event) {
    this.#pressed.delete(event.pointerId);
    this.#mayClick = false;
    if (this.#isDragging) this.#host.act((studio) => studio.cancel());
    this.#letGo();
  }

  #letGo() {
    this.#holder = undefined;
    this.#host.act((studio) => studio.release());
  }

  get #isDragging() {
    return this.#host.ask((studio) => studio.dragging) ?? false;
  }

  /**
   * Takes hold of what lies under the pointer, if anything does.
   *
   * @param {PointerEvent} event
   */
  #take(event) {
    const pointer = /** @type {PointerName} */ (event.pointerType);
    const place = this.#place(event);
    const hasTaken = this.#host.ask((studio) => studio.press(...place, pointer)) ?? false;
    if (hasTaken) this.#holder = event.pointerId;
    this.#host.requestFrame();
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const place = this.#place(event);
    this.#host.act((studio) => studio.drag(...place, event.shiftKey));
    this.#told.did("drag");
  }

  /** @param {KeyboardEvent} event while something is dragged: along an axis, or back to where it was */
  #key(event) {
    if (!this.#isDragging || event.ctrlKey || event.metaKey) return;
    const axis = AXIS_KEYS[event.key.toLowerCase()];
    if (event.key === "Escape") {
      event.stopPropagation();
      this.#host.act((studio) => studio.cancel());
    } else if (axis) {
      event.preventDefault();
      this.#host.act((studio) => studio.dragAlong(axis));
    }
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (this.#isDragging) this.#widen(1 / factor);
    else this.#host.act((studio) => studio.zoom(factor));
  }

  /** @param {number} factor by which a drag reaches further */
  #widen(factor) {
    if (!Number.isFinite(factor) || factor <= 0) return;
    this.#host.act((studio) => studio.widen(factor));
    this.#told.widened();
  }

  /**
   * @param {number} dx in CSS px
   * @param {number} dy
   * @param {boolean} moves rather than turns
   */
  #turn(dx, dy, moves) {
    const ratio = devicePixelRatio;
    this.#host.act((studio) => (moves ? studio.pan(dx * ratio, dy * ratio) : studio.orbit(dx * ratio, dy * ratio)));
    if (!moves) this.#told.did("turn");
  }

  /**
   * @param {Spread} before
   * @param {Spread} after
   */
  #pinch(before, after) {
    this.#turn(after.x - before.x, after.y - before.y, this.#pressed.size > 2);
    if (before.apart > 0 && after.apart > 0) this.#host.act((studio) => studio.zoom(after.apart / before.apart));
  }

  /**
   * Where the pointer is on the canvas, in its device pixels.
   *
   * @param {PointerEvent} event
   * @returns {[number, number]}
   */
  #place(event) {
    const { canvas } = this.#host;
    const box = canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) * canvas.width) / box.width,
      ((event.clientY - box.top) * canvas.height) / box.height,
    ];
  }
}

/**
 * The middle of all fingers, and how far the first two are apart.
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
