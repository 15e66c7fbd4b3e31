import { textOf } from "../../src/phrase.ts";
import { t, formatNumber } from "../words/words.js";
import { Gestures } from "./gestures.js";
import { placeTag } from "./tag-place.js";

/**
 * @typedef {import("./host.js").Host} Host
 * @typedef {import("./host.js").State} State
 * @typedef {import("./host.js").Phrase} Phrase
 *
 * @typedef {object} MarkOptions
 * @property {HTMLOutputElement} tag shows the landmark's name
 * @property {import("../photo/photo-overlay.js").PhotoOverlay} [overlay] photo with landmarks
 * @property {(action: "drag" | "turn") => void} [onGesture]
 * @property {(text: string) => void} [announce]
 */

/** Shows the name of the selected or hovered landmark, and marks it on the photo and on the mesh. */
export class LandmarkMarks {
  #tag;
  #options;
  /** @type {number | undefined} */
  #selected;
  /** Name of the selection. @type {Phrase | undefined} */
  #selectedName;
  /** @type {number | undefined} */
  #hovered;
  /** Name of what a drag from the hovered point moves. @type {Phrase | undefined} */
  #hoveredName;
  #isDragging = false;
  /** Pointer position over the view while nothing is pressed. @type {[number, number] | undefined} */
  #pointer_px;
  /** Influence radius, in mm. */
  #radius_mm = 0;
  /** Whether the current drag has changed the radius. */
  #isRadiusChanged = false;
  /** Whether the dragged point leaves the symmetry plane. */
  #leavesPlane = false;
  /** Whether the drag exceeds the edit's limit. */
  #isAtEnd = false;
  /** Whether the point cannot be moved. */
  #isRefused = false;

  /**
   * @param {Host} host
   * @param {MarkOptions} options
   */
  constructor(host, options) {
    this.host = host;
    this.#options = options;
    this.#tag = options.tag;
    host.onChange((state) => this.#update(state));
    host.onTick(({ isAtEnd }) => this.#setAtEnd(isAtEnd));
    host.onFrame(() => {
      this.#repeatHitTest();
      this.#place();
    });
    new Gestures(host, {
      hover: (x_px, y_px) => this.#hover(x_px, y_px),
      leave: () => {
        this.#pointer_px = undefined;
        this.#highlight(undefined);
      },
      press: () => {
        this.#pointer_px = undefined;
      },
      radiusChanged: () => {
        this.#isRadiusChanged = true;
        this.#write();
      },
      gesture: (action) => options.onGesture?.(action),
    });
    options.overlay?.listen({
      hover: (landmark) => this.#highlight(landmark),
      choose: (landmark) => host.apply({ "select-at": landmark }),
      press: () => host.apply({ scene: "picture" }),
    });
  }

  /** @param {State} state */
  #update({ selected, name, isSliding, isDragging, radiusMm, leavesPlane, isRefused }) {
    // A proportion slider moves other points.
    this.#selected = isSliding ? undefined : selected;
    this.#radius_mm = radiusMm;
    this.#leavesPlane = leavesPlane;
    this.#isRefused = isRefused;
    this.#selectedName = name;
    this.#isDragging = isDragging;
    if (!isDragging) this.#isRadiusChanged = false;
    // The change may have moved another point under the pointer.
    this.#hovered = undefined;
    this.#write();
  }

  /** @param {boolean} isAtEnd */
  #setAtEnd(isAtEnd) {
    if (isAtEnd === this.#isAtEnd) return;
    this.#isAtEnd = isAtEnd;
    this.#write();
    if (isAtEnd) this.#options.announce?.(this.#tag.value);
  }

  /** Highlights a landmark hovered on the photo. @param {number | undefined} landmark */
  #highlight(landmark) {
    const applied = this.host.apply({ "point-at": landmark });
    this.#showName(landmark, applied?.hoveredName);
  }

  /**
   * @param {number} x_px
   * @param {number} y_px
   */
  #hover(x_px, y_px) {
    this.#pointer_px = [x_px, y_px];
    this.#setHovered(this.host.apply({ hover: this.#pointer_px }));
  }

  /** Repeats the hit test after each frame: the face may have moved under a resting pointer. */
  #repeatHitTest() {
    const place = this.#pointer_px;
    if (!place) return;
    // Without `apply`, which would request a frame each time.
    const applied = this.host.ask((studio) => studio.apply({ hover: place }));
    if (applied?.hovered === this.#hovered) return;
    this.#setHovered(applied);
    this.host.requestFrame();
  }

  /** @param {ReturnType<Host["apply"]>} applied answer to a movement of the pointer */
  #setHovered(applied) {
    this.host.canvas.classList.toggle("over-landmark", applied?.hovered !== undefined);
    this.#showName(applied?.hovered, applied?.hoveredName);
  }

  /**
   * @param {number | undefined} vertex
   * @param {Phrase | undefined} name
   */
  #showName(vertex, name) {
    if (vertex === this.#hovered) return;
    this.#hovered = vertex;
    this.#hoveredName = name;
    this.#write();
  }

  #write() {
    this.#options.overlay?.mark(this.#selected, this.#hovered);
    const selected = this.#selected === undefined ? undefined : this.#selectedName;
    const phrase = this.#hovered === undefined ? selected : this.#hoveredName;
    const name = phrase && textOf(phrase);
    this.#tag.hidden = name === undefined;
    if (name === undefined) return;
    this.#tag.value = this.#tagText(name);
    this.#place();
  }

  /** @param {string} name name of the dragged or hovered point */
  #tagText(name) {
    if (!this.#isDragging) return name;
    if (this.#isRefused) return t("landmark.refuses", { name });
    if (this.#isAtEnd) return t("landmark.at-end", { name });
    if (this.#isRadiusChanged) return t("landmark.reach", { name, mm: formatNumber(this.#radius_mm, 0) });
    return this.#leavesPlane ? t("landmark.alone", { name }) : name;
  }

  #place() {
    const named = this.#hovered ?? this.#selected;
    if (named === undefined) return;
    const place = this.host.ask((studio) => studio.screenPosition(named));
    if (!place) return;
    const [x = 0, y = 0] = [...place].map((side) => side / devicePixelRatio);
    this.#tag.dataset["place"] = `${x} ${y}`;
    const box = this.host.ask((studio) => [...studio.screenBox()]) ?? [];
    const [left = 0, top = 0, right = 0, bottom = 0] = box.map((side) => side / devicePixelRatio);
    placeTag(this.#tag, { x, y }, { left, top, right, bottom });
  }
}
