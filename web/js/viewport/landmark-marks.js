import { byId } from "../page/dom.js";
import { Gestures } from "./gestures.js";
import { sayOnce } from "../words/names.js";
import { say, sayNumber } from "../words/words.js";

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
  /** How far an edit reaches, in mm. */
  #radius_mm = 0;
  /** Whether that was changed by the drag that goes on. */
  #isWidened = false;

  /**
   * @param {Workbench} bench
   * @param {PhotoOverlay} overlay
   */
  constructor(bench, overlay) {
    this.bench = bench;
    this.overlay = overlay;
    bench.onChange((state) => {
      this.#selected = state.selected;
      this.#radius_mm = state.radiusMm;
      if (!bench.studio.dragging) this.#isWidened = false;
      // What was under the pointer may be another one by now, or none.
      this.#hovered = undefined;
      this.#write();
    });
    bench.onFrame(() => this.#place());
    new Gestures(bench, {
      hover: (x_px, y_px) => this.#point(x_px, y_px),
      leave: () => this.#pointAt(undefined),
      widened: () => {
        this.#isWidened = true;
        this.#write();
      },
    });
    overlay.listen({
      hover: (landmark) => this.#pointAt(landmark),
      choose: (landmark) => bench.act((studio) => studio.selectAt(landmark)),
    });
  }

  /**
   * Marks a landmark that the pointer is over on the photo, or nowhere.
   *
   * @param {number | undefined} landmark
   */
  #pointAt(landmark) {
    this.bench.act((studio) => studio.pointAt(landmark));
    this.#name(landmark);
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   */
  #point(x_px, y_px) {
    const vertex = this.bench.ask((studio) => studio.hover(x_px, y_px));
    this.bench.canvas.classList.toggle("over-landmark", this.bench.ask((studio) => studio.movable) ?? false);
    this.bench.requestFrame();
    this.#name(vertex);
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
    const name = named === undefined ? undefined : this.bench.ask((studio) => sayOnce(studio.targetAt(named)));
    this.#tag.hidden = name === undefined;
    if (name === undefined) return;
    const reach = { name, mm: sayNumber(this.#radius_mm, 0) };
    this.#tag.textContent = this.#isWidened ? say("landmark.reach", reach) : name;
    this.#place();
  }

  #place() {
    const named = this.#hovered ?? this.#selected;
    if (named === undefined) return;
    const place = this.bench.ask((studio) => studio.screenPosition(named));
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
