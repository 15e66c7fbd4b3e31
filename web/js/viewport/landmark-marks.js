import { byId } from "../page/dom.js";
import { Gestures } from "./gestures.js";
import { isAtLandmark } from "./landmark-drag.js";
import { language, say, sayNumber } from "../words/words.js";

/**
 * @typedef {import("./workbench.js").Workbench} Workbench
 * @typedef {import("../photo/photo-overlay.js").PhotoOverlay} PhotoOverlay
 */

/** What stays free beside a name. */
const MARGIN_PX = 8;

/** Keeps the landmark's name beside it, and the same landmark marked on the photo and on the mesh. */
export class LandmarkMarks {
  #tag = byId("landmark-tag", HTMLOutputElement);
  /** @type {number | undefined} */
  #selected;
  /** @type {number | undefined} */
  #hovered;
  /** @type {number | undefined} while a drag goes on whose reach was changed */
  #reach_mm;

  /**
   * @param {Workbench} bench
   * @param {PhotoOverlay} overlay
   * @param {(factor: number) => number} widen changes how far an edit reaches, in mm
   */
  constructor(bench, overlay, widen) {
    this.bench = bench;
    this.overlay = overlay;
    bench.onChange((state) => {
      this.#selected = state.selected;
      if (!state.editing) this.#reach_mm = undefined;
      this.#write();
    });
    bench.onFrame(() => this.#place());
    new Gestures(bench, {
      pick: (x_px, y_px) => this.#take(bench.studio.pick(x_px, y_px)),
      pin: (x_px, y_px) => this.#pin(bench.studio.pick(x_px, y_px)),
      hover: (x_px, y_px) => this.#point(x_px, y_px),
      leave: () => this.hover(undefined),
      widen: (factor) => (this.#reach_mm = widen(factor)),
    });
    overlay.listen({ hover: (landmark) => this.hover(landmark), choose: (landmark) => this.#take(landmark) });
  }

  /**
   * Marks a landmark that the pointer is over, on the photo or nowhere.
   *
   * @param {number | undefined} landmark
   */
  hover(landmark) {
    this.bench.look((studio) => studio.hoverVertex(landmark));
    this.#name(landmark);
  }

  /**
   * Takes what is there in hand, or lets go where there is nothing.
   *
   * @param {number | undefined} landmark
   */
  #take(landmark) {
    this.bench.act((studio) => (landmark === undefined ? studio.select() : studio.takeAt(landmark)));
  }

  /** @param {number | undefined} landmark */
  #pin(landmark) {
    if (landmark !== undefined) this.bench.act((studio) => studio.togglePin(landmark));
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   */
  #point(x_px, y_px) {
    this.bench.look((studio) => {
      const landmark = studio.hover(x_px, y_px);
      const isOnLandmark = landmark !== undefined && isAtLandmark(studio, landmark, x_px, y_px, "mouse");
      const movable = isOnLandmark || studio.pickAxis(x_px, y_px, "mouse") !== undefined;
      this.bench.canvas.classList.toggle("over-landmark", movable);
      this.#name(landmark);
    });
  }

  /** @param {number | undefined} landmark */
  #name(landmark) {
    if (landmark === this.#hovered) return;
    this.#hovered = landmark;
    this.#write();
  }

  #write() {
    this.overlay.mark(this.#selected, this.#hovered);
    const named = this.#hovered ?? this.#selected;
    this.#tag.hidden = named === undefined;
    if (named !== undefined) this.#tag.textContent = this.#nameOf(named);
    this.#place();
  }

  /** @param {number} landmark */
  #nameOf(landmark) {
    const name = this.bench.studio.nameAt(landmark, language());
    return this.#reach_mm === undefined ? name : say("landmark.reach", { name, mm: sayNumber(this.#reach_mm, 0) });
  }

  #place() {
    const named = this.#hovered ?? this.#selected;
    if (named === undefined) return;
    const place = this.bench.studio.screenPosition(named);
    if (!place) return;
    const ratio = devicePixelRatio;
    const left_px = Math.round(place.x / ratio + 14);
    this.#tag.style.translate = `${left_px}px ${Math.round(place.y / ratio + 12)}px`;
    // Long names are drawn back into the picture.
    const room_px = this.bench.canvas.clientWidth - left_px - MARGIN_PX;
    this.#tag.style.marginLeft = `${Math.min(0, room_px - this.#tag.offsetWidth)}px`;
    place.free();
  }
}
