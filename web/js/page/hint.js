import { onLocaleChange, t } from "../words/words.js";
import { byId } from "./dom.js";
import { remember, remembered } from "./remember.js";

/** What a newcomer is told to do, one after the other. */
const DEEDS = /** @type {const} */ (["drag", "turn"]);

/** @typedef {typeof DEEDS[number]} Deed */

/** @type {Set<string>} */
const done = new Set();
let isOffering = false;
/** @type {Set<(deed: Deed | undefined) => void>} */
const listeners = new Set();

/** Writes the hints in the page's language. */
export function setUpHints() {
  for (const deed of DEEDS) if (remembered(`did.${deed}`)) done.add(deed);
  onLocaleChange(write);
}

/** Gives the first hint that was not followed yet; it stays until it is. */
export function giveHints() {
  isOffering = true;
  write();
}

/**
 * Something was done that a hint may have been about.
 *
 * @param {Deed} deed
 */
export function did(deed) {
  if (done.has(deed)) return;
  done.add(deed);
  remember(`did.${deed}`, "yes");
  write();
}

/** @param {(deed: Deed | undefined) => void} listener is told now and later what is hinted at */
export function onHint(listener) {
  listeners.add(listener);
  listener(hinted());
}

/** @returns {Deed | undefined} */
function hinted() {
  return isOffering ? DEEDS.find((deed) => !done.has(deed)) : undefined;
}

function write() {
  const element = byId("hint", HTMLParagraphElement);
  const deed = hinted();
  element.hidden = deed === undefined;
  if (deed) element.textContent = t(`hint.${deed}`);
  for (const listener of listeners) listener(deed);
}
