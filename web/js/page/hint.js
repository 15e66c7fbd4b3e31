import { onLocaleChange, t } from "../words/words.js";
import { byId } from "../../src/dom.ts";
import { remember, remembered } from "./remember.js";

/** Actions that the hints suggest, in order. */
const ACTIONS = /** @type {const} */ (["drag", "turn"]);

/** @typedef {typeof ACTIONS[number]} Action */

/** @type {Set<string>} */
const completed = new Set();
let isShowing = false;
/** @type {Set<(action: Action | undefined) => void>} */
const listeners = new Set();

/** Loads completed hints and writes the current one in each locale. */
export function setUpHints() {
  for (const action of ACTIONS) if (remembered(`did.${action}`)) completed.add(action);
  onLocaleChange(write);
}

/** Shows the first hint that is not completed yet. */
export function showHints() {
  isShowing = true;
  write();
}

/** Marks the action's hint as completed. @param {Action} action */
export function completeHint(action) {
  if (completed.has(action)) return;
  completed.add(action);
  remember(`did.${action}`, "yes");
  write();
}

/** @param {(action: Action | undefined) => void} listener called now and later with the suggested action */
export function onHint(listener) {
  listeners.add(listener);
  listener(suggested());
}

/** @returns {Action | undefined} */
function suggested() {
  return isShowing ? ACTIONS.find((action) => !completed.has(action)) : undefined;
}

function write() {
  const element = byId("hint", HTMLParagraphElement);
  const action = suggested();
  element.hidden = action === undefined;
  if (action) element.textContent = t(`hint.${action}`);
  for (const listener of listeners) listener(action);
}
