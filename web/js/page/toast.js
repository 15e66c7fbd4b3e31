import { announce } from "./announce.js";
import { byId } from "./dom.js";

/** Long enough to be read once. */
const SHOWN_MS = 4000;

let leaving = 0;

/**
 * Says that something was done, to those who see it and to those who do not.
 *
 * @param {string} words
 */
export function toast(words) {
  const element = byId("toast", HTMLParagraphElement);
  element.textContent = words;
  element.hidden = false;
  announce(words);
  clearTimeout(leaving);
  leaving = setTimeout(() => (element.hidden = true), SHOWN_MS);
}
