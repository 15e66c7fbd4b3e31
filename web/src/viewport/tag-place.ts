type Box = { left: number; top: number; right: number; bottom: number; };

/** Distance of the name from its point and from the stage's edge, in CSS px. */
const SIDE_PX = 14;
const BELOW_PX = 12;
const MARGIN_PX = 8;

/** Lowest part of the face that the name must not cover, as a share of the face's height. */
const CHIN = 0.22;

/**
 * Places the name below and to the right of its point, clear of the gizmo; to the left at the stage's edge. Near the
 * chin, the name goes below the face, or next to it if the toolbar is in the way.
 *
 * @param point CSS px from the stage's top left
 */
export function placeTag(tag: HTMLElement, point: { x: number; y: number; }, face: Box) {
  const stage = { width: tag.parentElement?.clientWidth ?? 0, height: toolbarTop(tag) };
  const { offsetWidth: width, offsetHeight: height } = tag;
  const isAtChin = point.y + BELOW_PX + height > face.bottom - CHIN * (face.bottom - face.top);
  const fitsBelow = face.bottom + MARGIN_PX + height < stage.height;
  const x = isAtChin && !fitsBelow ? Math.max(point.x, face.right) : point.x;
  const y = isAtChin && fitsBelow ? face.bottom + MARGIN_PX : point.y + BELOW_PX;
  const fitsRight = x + SIDE_PX + width + MARGIN_PX <= stage.width;
  const left = fitsRight ? x + SIDE_PX : Math.min(x - SIDE_PX, stage.width - MARGIN_PX) - width;
  const top = clamp(y, MARGIN_PX, stage.height - height - MARGIN_PX);
  tag.style.translate = `${Math.round(Math.max(MARGIN_PX, left))}px ${Math.round(top)}px`;
}

/** Upper edge of the toolbar. */
function toolbarTop(tag: HTMLElement) {
  const stage = tag.parentElement;
  const toolbar = (stage?.querySelector("[role=toolbar]") as HTMLElement | null | undefined);
  const floor = stage?.clientHeight ?? 0;
  return toolbar && !toolbar.hidden ? Math.min(floor, toolbar.offsetTop) : floor;
}

function clamp(value: number, min: number, max: number) {
  return Math.max(min, Math.min(value, max));
}
