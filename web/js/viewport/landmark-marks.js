import { announceOnce } from "../words/names.js";
import { t, formatNumber } from "../words/words.js";
import { Gestures } from "./gestures.js";
import { placeTag } from "./tag-place.js";

/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {import("./host.js").StudioState} StudioState
 *
 * @typedef {object} Around what else shows what the pointer does
 * @property {HTMLOutputElement} tag that has the landmark's name
 * @property {import("../photo/photo-overlay.js").PhotoOverlay} [overlay] the photo with its landmarks
 * @property {(deed: "drag" | "turn") => void} [did]
 * @property {(text: string) => void} [announce]
 */

/** Keeps the landmark's name beside it, and the same landmark marked on the photo, if that is shown, and on the mesh. */
export class LandmarkMarks {
  #tag;
  #around;
  /** @type {number | undefined} */
  #selected;
  /** @type {number | undefined} */
  #hovered;
  /** Where the pointer rests over the view, while nothing is pressed. @type {[number, number] | undefined} */
  #resting_px;
  /** How far an edit reaches, in mm. */
  #radius_mm = 0;
  /** Whether that was changed by the drag that goes on. */
  #isWidened = false;
  /** Whether what is dragged goes sideways without the mirror. */
  #leavesPlane = false;
  /** Whether it is dragged further than it goes. */
  #isAtEnd = false;
  /** Why it cannot be moved. @type {string | undefined} */
  #refusal;

  /**
   * @param {Host} host
   * @param {Around} around
   */
  constructor(host, around) {
    this.host = host;
    this.#around = around;
    this.#tag = around.tag;
    host.onChange((state) => this.#follow(state));
    host.onTick(({ isAtEnd }) => this.#setAtEnd(isAtEnd));
    host.onFrame(() => {
      this.#lookAgain();
      this.#place();
    });
    new Gestures(host, {
      hover: (x_px, y_px) => this.#point(x_px, y_px),
      leave: () => {
        this.#resting_px = undefined;
        this.#pointAt(undefined);
      },
      press: () => {
        this.#resting_px = undefined;
      },
      widened: () => {
        this.#isWidened = true;
        this.#write();
      },
      did: (deed) => around.did?.(deed),
    });
    around.overlay?.listen({
      hover: (landmark) => this.#pointAt(landmark),
      choose: (landmark) => host.act((studio) => studio.selectAt(landmark)),
      press: () => host.act((studio) => studio.choose("scene", "picture")),
    });
  }

  /** @param {StudioState} state */
  #follow({ selected, isSliding, radiusMm, leavesPlane, refusal }) {
    // A ready-made slider moves something else.
    this.#selected = isSliding ? undefined : selected;
    this.#radius_mm = radiusMm;
    this.#leavesPlane = leavesPlane;
    this.#refusal = refusal;
    if (!this.host.ask((studio) => studio.dragging)) this.#isWidened = false;
    // What was under the pointer may be another one by now, or none.
    this.#hovered = undefined;
    this.#write();
  }

  /** @param {boolean} isAtEnd */
  #setAtEnd(isAtEnd) {
    if (isAtEnd === this.#isAtEnd) return;
    this.#isAtEnd = isAtEnd;
    this.#write();
    if (isAtEnd) this.#around.announce?.(this.#tag.value);
  }

  /**
   * Marks a landmark that the pointer is over on the photo, or nowhere.
   *
   * @param {number | undefined} landmark
   */
  #pointAt(landmark) {
    this.host.act((studio) => studio.pointAt(landmark));
    this.#name(landmark);
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   */
  #point(x_px, y_px) {
    this.#resting_px = [x_px, y_px];
    this.#light(this.host.ask((studio) => studio.hover(x_px, y_px)));
    this.host.requestFrame();
  }

  /** The face may have moved below a pointer that rests: what lights up is what a press would take now. */
  #lookAgain() {
    const place = this.#resting_px;
    if (!place) return;
    const vertex = this.host.ask((studio) => studio.hover(...place));
    if (vertex === this.#hovered) return;
    this.#light(vertex);
    this.host.requestFrame();
  }

  /** @param {number | undefined} vertex below the pointer */
  #light(vertex) {
    this.host.canvas.classList.toggle("over-landmark", vertex !== undefined);
    this.#name(vertex);
  }

  /** @param {number | undefined} landmark */
  #name(landmark) {
    if (landmark === this.#hovered) return;
    this.#hovered = landmark;
    this.#write();
  }

  #write() {
    this.#around.overlay?.mark(this.#selected, this.#hovered);
    const named = this.#hovered ?? this.#selected;
    const name = named === undefined ? undefined : this.host.ask((studio) => announceOnce(studio.targetAt(named)));
    this.#tag.hidden = name === undefined;
    if (name === undefined) return;
    this.#tag.value = this.#tell(name);
    this.#place();
  }

  /** @param {string} name of what is dragged, or pointed at */
  #tell(name) {
    const isDragging = this.host.ask((studio) => studio.dragging) ?? false;
    if (!isDragging) return name;
    if (this.#refusal) return t("landmark.refuses", { name });
    if (this.#isAtEnd) return t("landmark.at-end", { name });
    if (this.#isWidened) return t("landmark.reach", { name, mm: formatNumber(this.#radius_mm, 0) });
    return this.#leavesPlane ? t("landmark.alone", { name }) : name;
  }

  #place() {
    const named = this.#hovered ?? this.#selected;
    if (named === undefined) return;
    const place = this.host.ask((studio) => studio.screenPosition(named));
    if (!place) return;
    const [x, y] = [place.x / devicePixelRatio, place.y / devicePixelRatio];
    place.free();
    this.#tag.dataset["place"] = `${x} ${y}`;
    const box = this.host.ask((studio) => [...studio.screenBox()]) ?? [];
    const [left = 0, top = 0, right = 0, bottom = 0] = box.map((side) => side / devicePixelRatio);
    placeTag(this.#tag, { x, y }, { left, top, right, bottom });
  }
}
