import { textOf } from "../panel/phrase.ts";
import { t, formatNumber } from "../words/words.ts";
import { Gestures } from "./gestures.ts";
import { placeTag } from "./tag-place.ts";
import type { Host,  } from "./host.ts";
import type { PhotoOverlay } from "../photo/photo-overlay.ts";
import type { Phrase, State } from "../../wasm/rosto-studio-web.js";

export interface MarkOptions {
  /** shows the landmark's name */
  tag: HTMLOutputElement;
  /** photo with landmarks */
  overlay?: PhotoOverlay;
  onGesture?: (action: "drag" | "turn") => void;
  announce?: (text: string) => void;
}

/** Shows the name of the selected or hovered landmark, and marks it on the photo and on the mesh. */
export class LandmarkMarks {
  readonly host: Host;
  #tag;
  #options;
  #selected: number | undefined;
  /** Name of the selection. */
  #selectedName: Phrase | undefined;
  #hovered: number | undefined;
  /** Name of what a drag from the hovered point moves. */
  #hoveredName: Phrase | undefined;
  #isDragging = false;
  /** Pointer position over the view while nothing is pressed. */
  #pointer_px: [number, number] | undefined;
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

  constructor(host: Host, options: MarkOptions) {
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
    options.overlay?.onHover((landmark) => this.#highlight(landmark));
  }

  #update({ selected, name, isSliding, isDragging, radiusMm, leavesPlane, isRefused }: State) {
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

  #setAtEnd(isAtEnd: boolean) {
    if (isAtEnd === this.#isAtEnd) return;
    this.#isAtEnd = isAtEnd;
    this.#write();
    if (isAtEnd) this.#options.announce?.(this.#tag.value);
  }

  /** Highlights a landmark hovered on the photo. */
  #highlight(landmark: number | undefined) {
    const applied = this.host.apply({ "point-at": landmark });
    this.#showName(landmark, applied?.hoveredName);
  }

  #hover(x_px: number, y_px: number) {
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

  /** @param applied answer to a movement of the pointer */
  #setHovered(applied: ReturnType<Host["apply"]>) {
    this.host.canvas.classList.toggle("over-landmark", applied?.hovered !== undefined);
    this.#showName(applied?.hovered, applied?.hoveredName);
  }

  #showName(vertex: number | undefined, name: Phrase | undefined) {
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

  /** @param name name of the dragged or hovered point */
  #tagText(name: string) {
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
