/** @typedef {{ left: number, top: number, right: number, bottom: number }} Box CSS px from the stage's top left */

/** How far a name stands from what it names, and from the stage's edge, in CSS px. */
const BESIDE_PX = 14;
const BELOW_PX = 12;
const MARGIN_PX = 8;

/** The lowest part of a face, as a share of its height, over which no name is written. */
const CHIN = 0.22;

/**
 * Puts a name below a point of the face and to its right, clear of the gizmo's arms, or to its left where the stage ends; for
 * what is at the chin below the face or, where the tools are in the way, at its side.
 *
 * @param {HTMLElement} tag
 * @param {{ x: number, y: number }} point CSS px from the stage's top left
 * @param {Box} face
 */
export function placeTag(tag, point, face) {
  const stage = { width: tag.parentElement?.clientWidth ?? 0, height: floorOf(tag) };
  const { offsetWidth: width, offsetHeight: height } = tag;
  const isAtChin = point.y + BELOW_PX + height > face.bottom - CHIN * (face.bottom - face.top);
  const isRoomBelow = face.bottom + MARGIN_PX + height < stage.height;
  const x = isAtChin && !isRoomBelow ? Math.max(point.x, face.right) : point.x;
  const y = isAtChin && isRoomBelow ? face.bottom + MARGIN_PX : point.y + BELOW_PX;
  const isRoomRight = x + BESIDE_PX + width + MARGIN_PX <= stage.width;
  const left = isRoomRight ? x + BESIDE_PX : Math.min(x - BESIDE_PX, stage.width - MARGIN_PX) - width;
  const top = within(y, MARGIN_PX, stage.height - height - MARGIN_PX);
  tag.style.translate = `${Math.round(Math.max(MARGIN_PX, left))}px ${Math.round(top)}px`;
}

/**
 * Where the tools at the stage's lower edge begin.
 *
 * @param {HTMLElement} tag
 */
function floorOf(tag) {
  const stage = tag.parentElement;
  const toolbar = /** @type {HTMLElement | null | undefined} */ (stage?.querySelector("[role=toolbar]"));
  const floor = stage?.clientHeight ?? 0;
  return toolbar && !toolbar.hidden ? Math.min(floor, toolbar.offsetTop) : floor;
}

/**
 * @param {number} value
 * @param {number} least
 * @param {number} most
 */
function within(value, least, most) {
  return Math.max(least, Math.min(value, most));
}
