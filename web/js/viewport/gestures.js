/** @typedef {import("./workbench.js").Workbench} Workbench */

/** A press that moves less than this is a click, in CSS px. */
const CLICK_SLOP_PX = 4;

/** One notch of a wheel zooms by about a tenth. */
const ZOOM_PER_WHEEL_PX = 0.001;

/**
 * Turns pointers on the canvas into intents: left drag or one finger orbits, right drag or two fingers pan, wheel or
 * pinch zooms, a click picks.
 *
 * @param {Workbench} bench
 * @param {{ pick: (x_px: number, y_px: number) => void, hover: (x_px: number, y_px: number) => void, leave: () => void }} told
 *   places in device pixels of the canvas
 */
export function setUpGestures(bench, told) {
  const { canvas } = bench;
  /** @type {Map<number, { x: number, y: number, button: number }>} */
  const pressed = new Map();
  let moved_px = 0;

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    canvas.focus({ preventScroll: true });
    if (pressed.size === 0) moved_px = 0;
    pressed.set(event.pointerId, { x: event.clientX, y: event.clientY, button: event.button });
  });

  canvas.addEventListener("pointermove", (event) => {
    const from = pressed.get(event.pointerId);
    if (!from) return told.hover(...place(canvas, event));
    const before = spreadOf(pressed);
    const to = { x: event.clientX, y: event.clientY, button: from.button };
    pressed.set(event.pointerId, to);
    const dx = to.x - from.x;
    const dy = to.y - from.y;
    moved_px += Math.hypot(dx, dy);
    if (moved_px < CLICK_SLOP_PX) return;
    if (pressed.size > 1) pinch(bench, before, spreadOf(pressed));
    else drag(bench, dx, dy, from.button === 2 || event.shiftKey);
  });

  const release = (/** @type {PointerEvent} */ event) => {
    const from = pressed.get(event.pointerId);
    pressed.delete(event.pointerId);
    const isClick = event.type === "pointerup" && moved_px < CLICK_SLOP_PX && from?.button === 0;
    if (isClick && pressed.size === 0) told.pick(...place(canvas, event));
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
  canvas.addEventListener("pointerleave", () => told.leave());
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const scroll_px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
      bench.look((studio) => studio.zoom(Math.exp(-scroll_px * ZOOM_PER_WHEEL_PX)));
    },
    { passive: false },
  );
}

/**
 * @param {Workbench} bench
 * @param {number} dx
 * @param {number} dy
 * @param {boolean} pans
 */
function drag(bench, dx, dy, pans) {
  const ratio = devicePixelRatio;
  bench.look((studio) => (pans ? studio.pan(dx * ratio, dy * ratio) : studio.orbit(dx * ratio, dy * ratio)));
}

/**
 * Two fingers: their middle pans, their distance zooms.
 *
 * @param {Workbench} bench
 * @param {Spread} before
 * @param {Spread} after
 */
function pinch(bench, before, after) {
  const ratio = devicePixelRatio;
  bench.look((studio) => {
    studio.pan((after.x - before.x) * ratio, (after.y - before.y) * ratio);
    if (before.apart > 0 && after.apart > 0) studio.zoom(after.apart / before.apart);
  });
}

/**
 * @typedef {{ x: number, y: number, apart: number }} Spread the fingers' middle and distance, in CSS px
 *
 * @param {Map<number, { x: number, y: number }>} pressed
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

/**
 * Where the pointer is on the canvas, in its device pixels.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {PointerEvent} event
 * @returns {[number, number]}
 */
function place(canvas, event) {
  const box = canvas.getBoundingClientRect();
  return [
    ((event.clientX - box.left) * canvas.width) / box.width,
    ((event.clientY - box.top) * canvas.height) / box.height,
  ];
}
