import { byId } from "../page/dom.ts";

/** A movement shorter than this is a press, in CSS px. */
const SLOP_PX = 4;

/** Sets up the handle with which the panel of small windows is made taller: by a press, or by dragging. */
export function setUpSheet() {
  const handle = byId("sheet-handle", HTMLButtonElement);
  const panel = byId("panel", HTMLElement);
  let start: { y: number; height: number } | undefined;
  let isDragged = false;
  const show = (isTall: boolean) => {
    panel.style.height = "";
    panel.toggleAttribute("data-tall", isTall);
    handle.ariaExpanded = String(isTall);
  };
  handle.addEventListener("pointerdown", ({ pointerId, clientY }) => {
    handle.setPointerCapture(pointerId);
    start = { y: clientY, height: panel.offsetHeight };
    isDragged = false;
  });
  handle.addEventListener("pointermove", ({ clientY }) => {
    if (!start) return;
    const up_px = start.y - clientY;
    isDragged ||= Math.abs(up_px) > SLOP_PX;
    if (isDragged) panel.style.height = `${start.height + up_px}px`;
  });
  handle.addEventListener("lostpointercapture", ({ clientY }) => {
    if (start && isDragged) show(clientY < start.y);
    start = undefined;
  });
  handle.addEventListener("click", () => isDragged || show(!panel.hasAttribute("data-tall")));
}
