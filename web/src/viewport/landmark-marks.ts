import { textOf } from "../panel/phrase.ts";
import { t, formatNumber } from "../words/words.ts";
import { placeOf, placeTag } from "./tag-place.ts";
import type { Host } from "./host.ts";
import type { PhotoOverlay } from "../photo/photo-overlay.ts";
import type { Applied, State } from "../../wasm/rosto-studio-web.js";

interface MarkOptions {
  /** Shows the landmark's name. */
  tag: HTMLOutputElement;
  /** Photo with landmarks. */
  overlay?: PhotoOverlay;
  announce?: (text: string) => void;
}

/** Shows the name of the selected or hovered landmark, and marks it on the photo and on the mesh. */
export function setUpMarks(host: Host, { tag, overlay, announce }: MarkOptions) {
  let state: Partial<State> = {};
  /** The point under the pointer, and the name of what a drag from it moves. */
  let pointed: Partial<Applied> = {};
  /** Whether the current drag has changed the influence radius. */
  let isRadiusChanged = false;
  /** Whether the drag exceeds the edit's limit. */
  let isAtEnd = false;

  // A proportion slider moves other points.
  const selected = () => (state.isSliding ? undefined : state.selected);
  const place = () => {
    const named = pointed.hovered ?? selected();
    const at = named === undefined ? undefined : placeOf(host, named);
    if (!at) return;
    tag.dataset["place"] = `${at.x} ${at.y}`;
    tag.style.opacity = String(host.ask((studio) => studio.toolsOpacity) ?? 0);
    placeTag(tag, host, at);
  };
  const write = () => {
    overlay?.mark(selected(), pointed.hovered);
    const selectedName = selected() === undefined ? undefined : state.name;
    const name = pointed.hovered === undefined ? selectedName : pointed.hoveredName;
    tag.hidden = !name;
    if (!name) return;
    tag.value = tagText(textOf(name));
    place();
  };
  const tagText = (name: string) => {
    if (!state.isDragging) return name;
    if (state.isRefused) return t("landmark.refuses", { name });
    if (isAtEnd) return t("landmark.at-end", { name });
    if (isRadiusChanged) return t("landmark.reach", { name, mm: formatNumber(state.radiusMm ?? 0, 0) });
    return state.leavesPlane ? t("landmark.alone", { name }) : name;
  };

  host.on("change", (now) => {
    const hasScaled = state.isDragging && state.radiusMm !== now.radiusMm;
    isRadiusChanged = now.isDragging && (isRadiusChanged || hasScaled === true);
    state = now;
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
  host.on("applied", (applied) => {
    if (applied.hovered === pointed.hovered) return;
    pointed = applied;
    write();
  });
  host.on("frame", place);
  overlay?.onHover((landmark) => host.apply({ "point-at": landmark }));
}
