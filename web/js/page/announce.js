import { byId } from "../../src/dom.ts";

/**
 * Announces a change to screen readers.
 *
 *
 * @param {string} words
 */
export function announce(words) {
  const region = byId("announcement", HTMLParagraphElement);
  // A live region does not announce the same text twice; a no-break space makes it differ.
  region.textContent = region.textContent === words ? `${words}\u00a0` : words;
}
