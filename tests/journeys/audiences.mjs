/** @typedef {{ id: string, options: import("@playwright/test").BrowserContextOptions }} Audience */

const TOUCH = { hasTouch: true, isMobile: true };

/** The windows that the page is looked at in: a laptop, a phone, a desk, a tablet, a phone on its side, a page at 200 %. */
export const AUDIENCES = /** @type {Audience[]} */ ([
  audience(1280, 720),
  audience(390, 844, { ...TOUCH, deviceScaleFactor: 2 }),
  audience(1440, 900),
  audience(820, 1180, TOUCH),
  audience(844, 390, TOUCH),
  audience(720, 450),
]);

/** What a browser of somebody who reads a language asks for. @type {Record<string, string>} */
export const LOCALES = { en: "en-GB", pt: "pt-BR" };

/** @param {number} width @param {number} height @param {object} [others] @returns {Audience} */
function audience(width, height, others = {}) {
  return { id: `${width}x${height}`, options: { viewport: { width, height }, ...others } };
}
