import type { Host } from "./host.ts";

/** Distance of the name from its point and from the stage's edge, in CSS px. */
const SIDE_PX = 14;
const BELOW_PX = 12;
const MARGIN_PX = 8;

/** Lowest part of the face that the name must not cover, as a share of the face's height. */
const CHIN = 0.22;

/** Position of a vertex in CSS px from the stage's top left, if it is in front of the camera. */
export function placeOf(host: Host, vertex: number) {
  const place = host.ask((studio) => studio.screenPosition(vertex));
  const [x = 0, y = 0] = place ?? [];
  return place && { x: x / devicePixelRatio, y: y / devicePixelRatio };
}

/**
 * Places the name below and to the right of its point, clear of the gizmo; to the left at the stage's edge. Near the
 * chin, the name goes below the face, or next to it if the toolbar is in the way.
 *
 * @param at CSS px from the stage's top left
 */
export function placeTag(tag: HTMLElement, host: Host, at: { x: number; y: number }) {
  const box = host.ask((studio) => [...studio.screenBox()]) ?? [];
  const [, top = 0, right = 0, bottom = 0] = box.map((side) => side / devicePixelRatio);
  const { offsetWidth: width, offsetHeight: height, parentElement: stage } = tag;
  const { clientWidth = 0, clientHeight = 0 } = stage ?? {};
  const toolbar = stage?.querySelector<HTMLElement>("[role=toolbar]:not([hidden])");
  const floor = Math.min(clientHeight, toolbar?.offsetTop ?? clientHeight);
  const isAtChin = at.y + BELOW_PX + height > bottom - CHIN * (bottom - top);
  const fitsBelow = bottom + MARGIN_PX + height < floor;
  const x = isAtChin && !fitsBelow ? Math.max(at.x, right) : at.x;
  const y = isAtChin && fitsBelow ? bottom + MARGIN_PX : at.y + BELOW_PX;
  const fitsRight = x + SIDE_PX + width + MARGIN_PX <= clientWidth;
  const left = fitsRight ? x + SIDE_PX : Math.min(x - SIDE_PX, clientWidth - MARGIN_PX) - width;
  const clamped = Math.max(MARGIN_PX, Math.min(y, floor - height - MARGIN_PX));
  tag.style.translate = `${Math.round(Math.max(MARGIN_PX, left))}px ${Math.round(clamped)}px`;
}
