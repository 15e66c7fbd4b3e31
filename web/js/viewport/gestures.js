import { LandmarkDrag } from "./landmark-drag.js";

/** @typedef {import("./workbench.js").Workbench} Workbench */
/** @typedef {{ x: number, y: number, button: number }} Press in CSS px of the window */
/** @typedef {{ x: number, y: number, apart: number }} Spread the fingers' middle and distance, in CSS px */

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

/** A finger that rests for this long picks what lies under it. */
const LONG_PRESS_MS = 450;

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
  #bench;
  #told;
  #drag;

  /**
   * @param {Workbench} bench
   * @param {{ pick: (x_px: number, y_px: number) => void, pin: (x_px: number, y_px: number) => void, hover: (x_px: number, y_px: number) => void, leave: () => void, widen: (factor: number) => void }} told
   *   places in device pixels of the canvas
   */
  constructor(bench, told) {
    this.#bench = bench;
    this.#told = told;
    this.#drag = new LandmarkDrag(bench, told);
    const { canvas } = bench;
    canvas.addEventListener("pointerdown", (event) => this.#press(event));
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", (event) => this.#lose(event));
    canvas.addEventListener("pointerleave", () => told.leave());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const { canvas } = this.#bench;
    canvas.setPointerCapture(event.pointerId);
    this.#pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: event.button });
    this.#mayClick = this.#pressed.size === 1 && event.button === 0;
    if (this.#pressed.size > 1) return this.#stopPress();
    this.#moved_px = 0;
    if (event.button === 0) this.#drag.press(...this.#place(event), event.pointerType);
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
    else if (this.#drag.isReady) this.#drag.move(...this.#place(event), event.shiftKey);
    else this.#turn(dx, dy, from.button !== 0 || event.shiftKey);
  }

  /** @param {PointerEvent} event */
  #release(event) {
    clearTimeout(this.#longPress);
    this.#pressed.delete(event.pointerId);
    this.#drag.release();
    if (!this.#mayClick) return;
    this.#mayClick = false;
    if (event.altKey) this.#told.pin(...this.#place(event));
    else this.#told.pick(...this.#place(event));
  }

  /** @param {PointerEvent} event */
  #lose(event) {
    this.#pressed.delete(event.pointerId);
    this.#mayClick = false;
    this.#stopPress();
  }

  #stopPress() {
    clearTimeout(this.#longPress);
    this.#drag.cancel();
  }

  /** @param {PointerEvent} event */
  #waitForLongPress(event) {
    clearTimeout(this.#longPress);
    const place = this.#place(event);
    this.#longPress = setTimeout(() => {
      // What follows is a drag of what was picked, or nothing.
      this.#mayClick = false;
      this.#told.pick(...place);
      this.#drag.press(...place, "touch");
    }, LONG_PRESS_MS);
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    event.preventDefault();
    const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
    const factor = Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX);
    if (this.#drag.isMoving) this.#drag.widen(factor);
    else this.#bench.look((studio) => studio.zoom(factor));
  }

  /**
   * @param {number} dx in CSS px
   * @param {number} dy
   * @param {boolean} pans rather than orbits
   */
  #turn(dx, dy, pans) {
    const ratio = devicePixelRatio;
    this.#bench.look((studio) => (pans ? studio.pan(dx * ratio, dy * ratio) : studio.orbit(dx * ratio, dy * ratio)));
  }

  /**
   * Two fingers: their middle pans, their distance zooms.
   *
   * @param {Spread} before
   * @param {Spread} after
   */
  #pinch(before, after) {
    const ratio = devicePixelRatio;
    this.#bench.look((studio) => {
      studio.pan((after.x - before.x) * ratio, (after.y - before.y) * ratio);
      if (before.apart > 0 && after.apart > 0) studio.zoom(after.apart / before.apart);
    });
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
