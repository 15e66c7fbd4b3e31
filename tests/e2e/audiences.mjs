const TOUCH = { hasTouch: true, isMobile: true };

/**
 * Windows that the tests use: laptop, phone, desktop, tablet, landscape phone, and a page at 200 % zoom.
 *
 * @type {{ id: string, options: import("@playwright/test").BrowserContextOptions }[]}
 */
export const AUDIENCES = [
  audience(1280, 720),
  audience(390, 844, { ...TOUCH, deviceScaleFactor: 2 }),
  audience(1440, 900),
  audience(820, 1180, TOUCH),
  audience(844, 390, TOUCH),
  audience(720, 450),
];

/** @param {number} width @param {number} height */
function audience(width, height, others = {}) {
  return { id: `${width}x${height}`, options: { viewport: { width, height }, ...others } };
}
