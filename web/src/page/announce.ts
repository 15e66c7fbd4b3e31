import { byId } from "./dom.ts";

/** Announces a change to screen readers. */
export function announce(words: string) {
  const region = byId("announcement", HTMLParagraphElement);
  // A live region does not announce the same text twice; a no-break space makes it differ.
  region.textContent = region.textContent === words ? `${words}\u00a0` : words;
}
