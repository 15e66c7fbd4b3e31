const TOUCH = { hasTouch: true, isMobile: true };

/**
 * Windows that the tests use: laptop, phone, desktop, tablet, landscape phone, and a page at 200 % zoom.
 *
 * @type {{ id: string, options: import("@playwright/test").BrowserContextOptions }[]}
 */
export const WINDOW_SIZES = [
  windowOf(1280, 720),
  windowOf(390, 844, { ...TOUCH, deviceScaleFactor: 2 }),
  windowOf(1440, 900),
  windowOf(820, 1180, TOUCH),
  windowOf(844, 390, TOUCH),
  windowOf(720, 450),
];

/** @param {number} width @param {number} height */
function windowOf(width, height, others = {}) {
  return { id: `${width}x${height}`, options: { viewport: { width, height }, ...others } };
}
