import { asTrouble, showTrouble } from "../page/notice.js";
import { GpuKeeper } from "./gpu-keeper.js";
import { openStudio } from "./studio-module.js";

/**
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioState} StudioState
 */

/**
 * Holds the studio, which holds the user's work, and tells the page when anything about it has changed. It draws
 * only in an animation frame, and asks for one only when there is something new to see.
 */
export class Workbench {
  #frameIsComing = false;
  #gpu;
  /** @type {Set<(state: StudioState) => void>} */
  #changeListeners = new Set();
  /** @type {Set<() => void>} */
  #frameListeners = new Set();

  /**
   * Opens a studio on the canvas; throws `{code: "no-webgl", …}` where the browser cannot draw in 3D.
   *
   * @param {HTMLCanvasElement} canvas
   */
  static async open(canvas) {
    return new Workbench(canvas, await openStudio(canvas));
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Studio} studio
   */
  constructor(canvas, studio) {
    this.canvas = canvas;
    this.studio = studio;
    this.#gpu = new GpuKeeper(canvas, studio, () => this.requestFrame());
    this.#followSize();
  }

  /**
   * Changes something that the panel shows: listeners are told, and a frame is drawn.
   *
   * @param {(studio: Studio) => void} change
   */
  act(change) {
    this.look(change);
    this.announce();
  }

  /**
   * Changes only what is seen, such as the camera.
   *
   * @param {(studio: Studio) => void} change
   */
  look(change) {
    try {
      change(this.studio);
    } catch (error) {
      showTrouble(error);
    }
    this.requestFrame();
  }

  /** @param {(state: StudioState) => void} listener */
  onChange(listener) {
    this.#changeListeners.add(listener);
  }

  /** @param {() => void} listener runs after each frame drawn */
  onFrame(listener) {
    this.#frameListeners.add(listener);
  }

  /** Tells every listener how things stand. */
  announce() {
    const state = this.studio.state();
    for (const listener of this.#changeListeners) listener(state);
    state.free();
  }

  /** Draws in the next animation frame. */
  requestFrame() {
    if (this.#frameIsComing) return;
    this.#frameIsComing = true;
    requestAnimationFrame((time_ms) => {
      this.#frameIsComing = false;
      this.#draw(time_ms);
    });
  }

  /** @param {number} time_ms */
  #draw(time_ms) {
    if (!this.#gpu.isThere) return;
    try {
      const wantsMore = this.studio.draw(time_ms);
      for (const listener of this.#frameListeners) listener();
      if (wantsMore) this.requestFrame();
    } catch (error) {
      if (asTrouble(error).code !== "device-lost") showTrouble(error);
    }
  }

  #followSize() {
    const observer = new ResizeObserver(([entry]) => {
      if (!entry) return;
      const size = deviceSize(entry);
      this.look((studio) => studio.resize(size.width_px, size.height_px, devicePixelRatio));
    });
    observer.observe(this.canvas);
  }
}

/**
 * The canvas's size in device pixels, exact where the browser tells it.
 *
 * @param {ResizeObserverEntry} entry
 */
function deviceSize(entry) {
  const about = { width_px: entry.contentRect.width * devicePixelRatio, height_px: entry.contentRect.height * devicePixelRatio };
  const exact = entry.devicePixelContentBoxSize?.[0];
  // It corrects a rounding; where it says something else altogether, the pixels it counts are not the page's.
  const isCorrection = exact && Math.abs(exact.inlineSize - about.width_px) < 2;
  const width_px = isCorrection ? exact.inlineSize : about.width_px;
  const height_px = isCorrection ? exact.blockSize : about.height_px;
  return { width_px: Math.max(1, Math.round(width_px)), height_px: Math.max(1, Math.round(height_px)) };
}
