/**
 * @typedef {import("./workbench.js").Workbench} Workbench
 * @typedef {import("../../wasm/rosto-studio-web.js").AxisName} AxisName
 * @typedef {import("../../wasm/rosto-studio-web.js").PointerName} PointerName
 */

const AXIS_KEYS = /** @type {Record<string, AxisName>} */ ({ x: "x", y: "y", z: "z" });

/** A drag that starts this near a landmark moves it, in CSS px; one that starts elsewhere turns the face. */
const REACH_PX = { mouse: 9, touch: 28 };

/**
 * @param {import("./workbench.js").Studio} studio
 * @param {number} landmark
 * @param {number} x_px in device pixels of the canvas
 * @param {number} y_px
 * @param {string} pointerType
 */
export function isAtLandmark(studio, landmark, x_px, y_px, pointerType) {
  const place = studio.screenPosition(landmark);
  if (!place) return false;
  const distance_px = Math.hypot(place.x - x_px, place.y - y_px) / devicePixelRatio;
  place.free();
  return distance_px <= (pointerType === "touch" ? REACH_PX.touch : REACH_PX.mouse);
}

/**
 * Moves a landmark with the pointer, in the view plane or along an axis. Escape puts it back, and what is left of the
 * press does nothing.
 */
export class LandmarkDrag {
  /** @type {"idle" | "ready" | "moving" | "over"} */
  #phase = "idle";
  /** @type {AxisName | undefined} */
  #axis;
  /** @type {number | undefined} */
  #landmark;
  #at = { x_px: 0, y_px: 0, fine: false };
  #bench;
  #told;

  /**
   * @param {Workbench} bench
   * @param {{ widen: (factor: number) => void }} told
   */
  constructor(bench, told) {
    this.#bench = bench;
    this.#told = told;
    addEventListener("keydown", (event) => this.#key(event), { capture: true });
  }

  /** Whether a press has taken hold of a landmark. */
  get isReady() {
    return this.#phase !== "idle";
  }

  get isMoving() {
    return this.#phase === "moving";
  }

  /**
   * Takes hold of what lies under the pointer. A finger only takes what is selected, as it hides what it touches.
   *
   * @param {number} x_px in device pixels of the canvas
   * @param {number} y_px
   * @param {string} pointerType
   */
  press(x_px, y_px, pointerType) {
    const { studio } = this.#bench;
    this.#phase = "idle";
    this.#axis = studio.pickAxis(x_px, y_px, /** @type {PointerName} */ (pointerType));
    const landmark = this.#axis ? studio.selected : studio.pick(x_px, y_px);
    if (landmark === undefined || (pointerType === "touch" && !studio.holds(landmark))) return;
    if (!this.#axis && !isAtLandmark(studio, landmark, x_px, y_px, pointerType)) return;
    this.#landmark = landmark;
    this.#at = { x_px, y_px, fine: false };
    this.#phase = "ready";
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   * @param {boolean} fine ten times slower
   */
  move(x_px, y_px, fine) {
    if (this.#phase === "over") return;
    if (this.#phase === "ready") this.#grab();
    this.#at = { x_px, y_px, fine };
    this.#follow();
  }

  /** Keeps the edit. */
  release() {
    if (this.#phase === "moving") this.#bench.act((studio) => studio.commit());
    this.#phase = "idle";
  }

  /** Puts the landmark back. */
  cancel() {
    if (this.#phase === "moving") this.#bench.act((studio) => studio.cancel());
    this.#phase = "idle";
  }

  /**
   * Changes how far the edit reaches.
   *
   * @param {number} factor
   */
  widen(factor) {
    this.#told.widen(factor);
    this.#follow();
  }

  #grab() {
    this.#phase = "moving";
    const landmark = this.#landmark;
    if (landmark !== undefined) this.#bench.act((studio) => studio.grab(landmark, this.#at.x_px, this.#at.y_px));
  }

  #giveUp() {
    this.cancel();
    this.#phase = "over";
  }

  #follow() {
    const { x_px, y_px, fine } = this.#at;
    this.#bench.act((studio) => studio.dragTo(x_px, y_px, this.#axis, fine));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (this.#phase !== "moving" || event.ctrlKey || event.metaKey) return;
    if (event.key === "Escape") {
      event.stopPropagation();
      return this.#giveUp();
    }
    const axis = AXIS_KEYS[event.key.toLowerCase()];
    if (axis === undefined) return;
    // The same key again frees the landmark.
    this.#axis = this.#axis === axis ? undefined : axis;
    event.preventDefault();
    this.#follow();
  }
}
