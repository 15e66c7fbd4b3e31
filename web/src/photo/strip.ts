/** Lines that a wheel reports in px. */
const LINE_PX = 16;

/** Lets the wheel scroll a strip sideways, and marks with `data-cut` the ends at which it is cut off. */
export function setUpStrip(strip: HTMLElement) {
  const mark = () => {
    const { scrollLeft, scrollWidth, clientWidth } = strip;
    const ends = { start: scrollLeft > 1, end: scrollLeft + clientWidth < scrollWidth - 1 };
    strip.dataset["cut"] = (["start", "end"] as const).filter((end) => ends[end]).join(" ");
  };
  strip.addEventListener("scroll", mark, { passive: true });
  strip.addEventListener("wheel", (event) => {
    const { deltaX, deltaY, deltaMode } = event;
    if (event.ctrlKey || Math.abs(deltaX) > Math.abs(deltaY)) return;
    event.preventDefault();
    strip.scrollLeft += deltaMode === WheelEvent.DOM_DELTA_LINE ? deltaY * LINE_PX : deltaY;
  });
  new ResizeObserver(mark).observe(strip);
  new MutationObserver(mark).observe(strip, { childList: true });
}
