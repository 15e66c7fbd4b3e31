/** Chromium 156 reports some changes of the device-pixel ratio neither to an observer nor to a media query. */
const RATIO_POLL_MS = 250;

/**
 * Follows the size of a canvas in device pixels, also when the device-pixel ratio changes. Returns a function that
 * applies the size again.
 */
export function followSize(canvas: HTMLCanvasElement, apply: (size_px: [number, number]) => void, signal: AbortSignal) {
  let entry: ResizeObserverEntry | undefined;
  let ratio = devicePixelRatio;
  const fit = () => {
    ratio = devicePixelRatio;
    if (entry) apply(deviceSize(entry));
  };
  const observer = new ResizeObserver(([latest]) => {
    entry = latest;
    fit();
  });
  try {
    observer.observe(canvas, { box: "device-pixel-content-box" });
  } catch {
    // WebKit does not have it.
    observer.observe(canvas);
  }
  const timer = setInterval(() => ratio !== devicePixelRatio && fit(), RATIO_POLL_MS);
  signal.addEventListener("abort", () => {
    observer.disconnect();
    clearInterval(timer);
  });
  return fit;
}

/** Size of the canvas in device pixels; exact if the browser reports it. */
function deviceSize({ contentRect, devicePixelContentBoxSize: [exact] = [] }: ResizeObserverEntry): [number, number] {
  const [width_px, height_px] = [contentRect.width * devicePixelRatio, contentRect.height * devicePixelRatio];
  // Only corrects rounding: a larger difference means that the browser counts other pixels.
  const isCorrection = exact && Math.abs(exact.inlineSize - width_px) < 2;
  const size_px = isCorrection ? [exact.inlineSize, exact.blockSize] : [width_px, height_px];
  const [width = 1, height = 1] = size_px.map((side) => Math.max(1, Math.round(side)));
  return [width, height];
}
