// Helpers of the layout checks. Runs in the page.

/** Tolerance for overlaps, in CSS px: browsers lay out in fractions. */
export const SLACK_PX = 1;

/** @param {Element} element */
export function isSeen(element) {
  if (element.closest(".visually-hidden, .skip-link, .symbols, svg *")) return false;
  const { width, height } = element.getBoundingClientRect();
  return width > 0 && height > 0 && element.checkVisibility({ visibilityProperty: true });
}

/** @param {Element} element */
export function nameOf(element) {
  if (element.id) return `#${element.id}`;
  const words = (element.textContent ?? "").trim().replaceAll(/\s+/g, " ").slice(0, 32);
  const kind = element.tagName.toLowerCase() + [...element.classList].map((name) => `.${name}`).join("");
  const section = element.closest("[id]");
  return `${section ? `#${section.id} ` : ""}${kind}${words ? ` “${words}”` : ""}`;
}

/** Elements over the 3D view. Excludes full-height ones that let pointer events through. */
export function floats() {
  const outer = ".stage > :not(.viewport, .visually-hidden, .welcome, .drop-veil, .focus-note, .photo-pane), #toast, #faces, .welcome > *";
  const isWhole = (element) => element.matches(".wipe");
  const all = [...document.querySelectorAll(outer)];
  return all.filter((element) => isSeen(element) && element.checkVisibility({ opacityProperty: true }) && !isWhole(element));
}

/** Size of the overlap of two boxes; undefined if there is none. @param {DOMRect} a @param {DOMRect} b */
export function overlap(a, b) {
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return width > SLACK_PX && height > SLACK_PX ? `${Math.round(width)} × ${Math.round(height)} px` : undefined;
}

/** Distance by which a box extends beyond a frame, horizontally and vertically. */
export function edgeOf(box, frame) {
  const across = Math.max(frame.left - box.left, box.right - frame.right);
  const along = Math.max(frame.top - box.top, box.bottom - frame.bottom);
  return { across: Math.round(across), along: Math.round(along) };
}

/** @param {Element} element */
export function hasOwnText(element) {
  return [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && (node.textContent ?? "").trim() !== "");
}

/** Boxes of an element's lines of text. @param {Element} element */
export function textOf(element) {
  const range = document.createRange();
  range.selectNodeContents(element);
  return [...range.getClientRects()].filter(({ width, height }) => width > 0 && height > 0);
}
