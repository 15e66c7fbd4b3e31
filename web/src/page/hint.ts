import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import { remember, remembered } from "./remember.ts";

/** Actions that the hints suggest, in order. */
const ACTIONS = (["drag", "turn"] as const);

export type Action = (typeof ACTIONS)[number];

const completed: Set<string> = new Set();
let isShowing = false;
const listeners: Set<(action: Action | undefined) => void> = new Set();

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

/** Marks the action's hint as completed. */
export function completeHint(action: Action) {
  if (completed.has(action)) return;
  completed.add(action);
  remember(`did.${action}`, "yes");
  write();
}

/** @param listener called now and later with the suggested action */
export function onHint(listener: (action: Action | undefined) => void) {
  listeners.add(listener);
  listener(suggested());
}

function suggested(): Action | undefined {
  return isShowing ? ACTIONS.find((action) => !completed.has(action)) : undefined;
}

function write() {
  const element = byId("hint", HTMLParagraphElement);
  const action = suggested();
  element.hidden = action === undefined;
  if (action) element.textContent = t(`hint.${action}`);
  for (const listener of listeners) listener(action);
}
