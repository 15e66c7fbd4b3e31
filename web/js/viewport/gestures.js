/**
 * @typedef {import("./workbench.js").Workbench} Workbench
 * @typedef {"x" | "y" | "z"} AxisName
 * @typedef {import("../../wasm/rosto-studio-web.js").PointerName} PointerName
 */
/** @typedef {{ x: number, y: number, button: number }} Press in CSS px of the window */
/** @typedef {{ x: number, y: number, apart: number }} Spread the fingers' middle and distance, in CSS px */

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

/** A finger that rests for this long picks what lies under it. */
const LONG_PRESS_MS = 450;

const AXIS_KEYS = /** @type {Record<string, AxisName>} */ ({ x: "x", y: "y", z: "z" });

/** One notch of a wheel zooms by about a tenth. */
const ZOOM_PER_WHEEL_PX = 0.001;

/**
 * Turns pointers on the canvas into intents: left drag or one finger orbits, right drag or two fingers pan, wheel or
 * pinch zooms, a click or a long press picks, a click with Alt pins, and a drag that starts on a landmark moves it.
 */
export class Gestures {
  /** @type {Map<number, Press>} */
  #pressed = new Map();
  /** Whether the press can still become a click. */
  #mayClick = false;
  #moved_px = 0;
  #longPress = 0;
  /** Whether the press has taken hold of something that it drags. */
  #hasTaken = false;
  #bench;
  #told;

  /**
   * @param {Workbench} bench
   * @param {{ hover: (x_px: number, y_px: number) => void, leave: () => void, widened: () => void }} told places in
   *   device pixels of the canvas
   */
  constructor(bench, told) {
    this.#bench = bench;
    this.#told = told;
    const { canvas } = bench;
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#lose(event));
    canvas.addEventListener("pointerleave", () => told.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
    addEventListener("keydown", (event) => this.#key(event), { capture: true });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const { canvas } = this.#bench;
    canvas.setPointerCapture(event.pointerId);
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: event.button });
    this.#mayClick = this.#pressed.size === 1 && event.button === 0;
    if (this.#pressed.size > 1) return this.#stopPress();
    this.#moved_px = 0;
    this.#hasTaken = false;
    if (event.button === 0) this.#take(...this.#place(event), event.pointerType);
    if (event.pointerType === "touch") this.#waitForLongPress(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const from = this.#pressed.get(event.pointerId);
    if (!from) return this.#told.hover(...this.#place(event));
    const before = spreadOf(this.#pressed);
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: from.button });
    const dx = event.clientX - from.x;
    const dy = event.clientY - from.y;
    this.#moved_px += Math.hypot(dx, dy);
    if (this.#moved_px < CLICK_SLOP_PX) return;
    this.#mayClick = false;
    clearTimeout(this.#longPress);
    if (this.#pressed.size > 1) this.#pinch(before, spreadOf(this.#pressed));
    else if (this.#hasTaken) this.#drag(...this.#place(event), event.shiftKey);
    else this.#turn(dx, dy, from.button !== 0 || event.shiftKey);
  }

  /** @param {PointerEvent} event */
  #release(event) {
    clearTimeout(this.#longPress);
    this.#pressed.delete(event.pointerId);
    this.#hasTaken = false;
    this.#bench.act((studio) => studio.release());
    if (!this.#mayClick) return;
    this.#mayClick = false;
    const place = this.#place(event);
    this.#bench.act((studio) => (event.altKey ? studio.pinUnder(...place) : studio.selectUnder(...place)));
  }

  /** @param {PointerEvent} event */
  #lose(event) {
    this.#pressed.delete(event.pointerId);
    this.#mayClick = false;
    this.#stopPress();
  }

  #stopPress() {
    clearTimeout(this.#longPress);
    this.#hasTaken = false;
    if (this.#isDragging) this.#bench.act((studio) => studio.cancel());
    this.#bench.act((studio) => studio.release());
  }

  get #isDragging() {
    return this.#bench.ask((studio) => studio.dragging) ?? false;
  }

  /**
   * Takes hold of what lies under the pointer, if anything does.
   *
   * @param {number} x_px
   * @param {number} y_px
   * @param {string} pointerType
   */
  #take(x_px, y_px, pointerType) {
    const pointer = /** @type {PointerName} */ (pointerType);
    this.#hasTaken = this.#bench.ask((studio) => studio.press(x_px, y_px, pointer)) ?? false;
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   * @param {boolean} fine
   */
  #drag(x_px, y_px, fine) {
    this.#bench.act((studio) => studio.drag(x_px, y_px, fine));
  }

  /** @param {KeyboardEvent} event while something is dragged: along an axis, or back to where it was */
  #key(event) {
    if (!this.#isDragging || event.ctrlKey || event.metaKey) return;
    const axis = AXIS_KEYS[event.key.toLowerCase()];
    if (event.key === "Escape") {
      event.stopPropagation();
      this.#bench.act((studio) => studio.cancel());
    } else if (axis) {
      event.preventDefault();
      this.#bench.act((studio) => studio.dragAlong(axis));
    }
  }

  /** @param {PointerEvent} event */
  #waitForLongPress(event) {
    clearTimeout(this.#longPress);
    const place = this.#place(event);
    this.#longPress = setTimeout(() => {
      // What follows is a drag of what was picked, or nothing.
      this.#mayClick = false;
      this.#bench.act((studio) => studio.selectUnder(...place));
      this.#take(...place, "touch");
    }, LONG_PRESS_MS);
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (!this.#isDragging) return this.#bench.act((studio) => studio.zoom(factor));
    this.#bench.act((studio) => studio.widen(1 / factor));
    this.#told.widened();
  }

  /**
   * @param {number} dx in CSS px
   * @param {number} dy
   * @param {boolean} pans rather than orbits
   */
  #turn(dx, dy, pans) {
    const ratio = devicePixelRatio;
    this.#bench.act((studio) => (pans ? studio.pan(dx * ratio, dy * ratio) : studio.orbit(dx * ratio, dy * ratio)));
  }

  /**
   * Two fingers: their middle pans, their distance zooms.
   *
   * @param {Spread} before
   * @param {Spread} after
   */
  #pinch(before, after) {
    const ratio = devicePixelRatio;
    this.#bench.act((studio) => studio.pan((after.x - before.x) * ratio, (after.y - before.y) * ratio));
    if (before.apart > 0 && after.apart > 0) this.#bench.act((studio) => studio.zoom(after.apart / before.apart));
  }

  /**
   * Where the pointer is on the canvas, in its device pixels.
   *
   * @param {PointerEvent} event
   * @returns {[number, number]}
   */
  #place(event) {
    const { canvas } = this.#bench;
    const box = canvas.getBoundingClientRect();
    return [
      ((event.clientX - box.left) * canvas.width) / box.width,
      ((event.clientY - box.top) * canvas.height) / box.height,
    ];
  }
}

/**
 * @param {Map<number, Press>} pressed
 * @returns {Spread}
 */
function spreadOf(pressed) {
  const [first = { x: 0, y: 0 }, second = first] = [...pressed.values()];
  return {
    x: (first.x + second.x) / 2,
    y: (first.y + second.y) / 2,
    apart: Math.hypot(first.x - second.x, first.y - second.y),
  };
}
