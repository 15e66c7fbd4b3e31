import { inEveryLanguage, say } from "../words/words.js";
import { byId } from "./dom.js";

/** @typedef {"drag" | "turn"} Hint */

const IDLE_MS = 3000;

/** Fingers do it in another way. */
const touch = matchMedia("(pointer: coarse)");

/** @type {Hint | undefined} */
let shown;
/** Each hint is given once in a visit. */
const given = new Set();
let idle = 0;

/** Hints go away with the next press of anything. */
export function setUpHints() {
  inEveryLanguage(write);
  for (const act of ["pointerdown", "keydown", "wheel"]) {
    addEventListener(act, () => {
      clearTimeout(idle);
      show(undefined);
    }, { capture: true, passive: true });
  }
}

/**
 * Gives a hint, and another if nothing happens for a while.
 *
 * @param {Hint} now
 * @param {Hint} later
 */
export function hint(now, later) {
  give(now);
  clearTimeout(idle);
  idle = setTimeout(() => give(later), IDLE_MS);
}

/** @param {Hint} key */
function give(key) {
  if (given.has(key)) return;
  given.add(key);
  show(key);
}

/** @param {Hint | undefined} key */
function show(key) {
  if (shown === key) return;
  shown = key;
  write();
}

function write() {
  const element = byId("hint", HTMLParagraphElement);
  element.hidden = shown === undefined;
  if (shown) element.textContent = say(touch.matches ? `hint.${shown}.touch` : `hint.${shown}`);
}
