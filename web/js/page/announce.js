import { byId } from "./dom.js";

/**
 * Says what happened to those who do not see it.
 *
 * @param {string} words
 */
export function announce(words) {
  const said = byId("said", HTMLParagraphElement);
  // The same words twice are only said once, unless something about them differs.
  said.textContent = said.textContent === words ? `${words}\u00a0` : words;
}
