import { textOf } from "../panel/phrase.ts";
import { t, formatNumber } from "../words/words.ts";
import { setUpGestures } from "./gestures.ts";
import { placeTag } from "./tag-place.ts";
import type { Host } from "./host.ts";
import type { PhotoOverlay } from "../photo/photo-overlay.ts";
import type { Phrase, State } from "../../wasm/rosto-studio-web.js";

interface MarkOptions {
  /** Shows the landmark's name. */
  tag: HTMLOutputElement;
  /** Photo with landmarks. */
  overlay?: PhotoOverlay;
  onGesture?: (action: "drag" | "turn") => void;
  announce?: (text: string) => void;
}

/** A point under the pointer, and the name of what a drag from it moves. */
type Pointed = { hovered?: number | undefined; hoveredName?: Phrase | undefined };

/** Shows the name of the selected or hovered landmark, and marks it on the photo and on the mesh. */
export function setUpMarks(host: Host, { tag, overlay, onGesture, announce }: MarkOptions) {
  let state: State | undefined;
  let pointed: Pointed = {};
  /** Pointer position over the view while nothing is pressed. */
  let pointer_px: [number, number] | undefined;
  /** Whether the current drag has changed the influence radius. */
  let isRadiusChanged = false;
  /** Whether the drag exceeds the edit's limit. */
  let isAtEnd = false;

  // A proportion slider moves other points.
  const selected = () => (state?.isSliding ? undefined : state?.selected);
  const write = () => {
    overlay?.mark(selected(), pointed.hovered);
    const selectedName = selected() === undefined ? undefined : state?.name;
    const name = pointed.hovered === undefined ? selectedName : pointed.hoveredName;
    tag.hidden = !name;
    if (!name) return;
    tag.value = tagText(textOf(name));
    place();
  };
  const tagText = (name: string) => {
    if (!state?.isDragging) return name;
    if (state.isRefused) return t("landmark.refuses", { name });
    if (isAtEnd) return t("landmark.at-end", { name });
    if (isRadiusChanged) return t("landmark.reach", { name, mm: formatNumber(state.radiusMm, 0) });
    return state.leavesPlane ? t("landmark.alone", { name }) : name;
  };
  const place = () => {
    const named = pointed.hovered ?? selected();
    const position = named === undefined ? undefined : host.ask((studio) => studio.screenPosition(named));
    if (!position) return;
    const [x = 0, y = 0] = [...position].map((side) => side / devicePixelRatio);
    tag.dataset["place"] = `${x} ${y}`;
    const box = host.ask((studio) => [...studio.screenBox()]) ?? [];
    const [left = 0, top = 0, right = 0, bottom = 0] = box.map((side) => side / devicePixelRatio);
    placeTag(tag, { x, y }, { left, top, right, bottom });
  };
  const show = (now: Pointed = {}) => {
    if (now.hovered === pointed.hovered) return;
    pointed = now;
    write();
  };
  /** Highlights a landmark hovered on the photo. */
  const highlight = (hovered: number | undefined) => {
    show({ hovered, hoveredName: host.apply({ "point-at": hovered })?.hoveredName });
  };
  const showUnderPointer = (applied: Pointed | undefined) => {
    host.canvas.classList.toggle("over-landmark", applied?.hovered !== undefined);
    show(applied);
  };

  host.on("change", (now) => {
    state = now;
    if (!now.isDragging) isRadiusChanged = false;
    // The change may have moved another point under the pointer.
    pointed = {};
    write();
  });
  host.on("tick", (tick) => {
    if (tick.isAtEnd === isAtEnd) return;
    isAtEnd = tick.isAtEnd;
    write();
    if (isAtEnd) announce?.(tag.value);
  });
  host.on("frame", () => {
    const px = pointer_px;
    // The face may have moved under a resting pointer. Without `apply`, which would request a frame each time.
    const applied = px && host.ask((studio) => studio.apply({ hover: px }));
    if (px && applied?.hovered !== pointed.hovered) {
      showUnderPointer(applied);
      host.requestFrame();
    }
    place();
  });
  setUpGestures(host, {
    hover: (x_px, y_px) => {
      pointer_px = [x_px, y_px];
      showUnderPointer(host.apply({ hover: pointer_px }));
    },
    leave: () => {
      pointer_px = undefined;
      highlight(undefined);
    },
    press: () => {
      pointer_px = undefined;
    },
    radiusChanged: () => {
      isRadiusChanged = true;
      write();
    },
    gesture: (action) => onGesture?.(action),
  });
  overlay?.onHover(highlight);
}
