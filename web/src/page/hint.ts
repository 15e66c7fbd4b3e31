import { onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import { remember, remembered } from "./remember.ts";

/** Actions that the hints suggest, in order. */
const ACTIONS = ["turn", "drag"] as const;

type Action = (typeof ACTIONS)[number];

let isShowing = false;

/** Writes the current hint in each locale. */
export function setUpHints() {
  onLocaleChange(write);
}

/** Shows the first hint that is not completed yet. */
export function showHints() {
  isShowing = true;
  write();
}

/** Marks the action's hint, or all hints, as completed, also for later visits. */
export function completeHints(...actions: Action[]) {
  const open = actions.filter((action) => !remembered(`did.${action}`));
  for (const action of open) remember(`did.${action}`, "yes");
  if (open.length > 0) write();
}

function write() {
  const element = byId("hint", HTMLParagraphElement);
  const suggested = isShowing ? ACTIONS.find((action) => !remembered(`did.${action}`)) : undefined;
  element.hidden = suggested === undefined;
  if (!suggested) return;
  [element.dataset["action"], element.textContent] = [suggested, t(`hint.${suggested}`)];
}
