import { announce } from "./announce.ts";
import { byId } from "./dom.ts";

/** Long enough to read once. */
const DURATION_MS = 4000;

let timer = 0;

/** Shows a confirmation, and announces it to screen readers. */
export function toast(words: string) {
  const element = byId("toast", HTMLParagraphElement);
  element.textContent = words;
  element.hidden = false;
  announce(words);
  clearTimeout(timer);
  timer = setTimeout(() => (element.hidden = true), DURATION_MS);
}
