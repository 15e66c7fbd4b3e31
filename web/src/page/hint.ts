import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import { remember, remembered } from "./remember.ts";

/** Actions that the hints suggest, in order. */
const ACTIONS = ["drag", "turn"] as const;

export type Action = (typeof ACTIONS)[number];

let isShowing = false;
const listeners = new Set<(action: Action | undefined) => void>();

/** Writes the current hint in each locale. */
export function setUpHints() {
  onHint((action) => {
    const element = byId("hint", HTMLParagraphElement);
    element.hidden = action === undefined;
    if (action) element.textContent = t(`hint.${action}`);
  });
  onLocaleChange(notify);
}

/** Shows the first hint that is not completed yet. */
export function showHints() {
  isShowing = true;
  notify();
}

/** Marks the action's hint as completed, also for later visits. */
export function completeHint(action: Action) {
  if (remembered(`did.${action}`)) return;
  remember(`did.${action}`, "yes");
  notify();
}

/** @param listener called now and later with the suggested action */
export function onHint(listener: (action: Action | undefined) => void) {
  listeners.add(listener);
  notify();
}

function notify() {
  const suggested = isShowing ? ACTIONS.find((action) => !remembered(`did.${action}`)) : undefined;
  for (const listener of listeners) listener(suggested);
}
