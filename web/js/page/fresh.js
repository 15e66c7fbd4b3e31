import { byId } from "./dom.js";

/**
 * Takes away what the panel still holds of the face before: what was being typed, the tab, and how far it was scrolled.
 *
 * @param {boolean} staysHere whether the visitor goes on where they are: another face of the same visit was chosen
 */
export function freshen(staysHere) {
  const panel = byId("panel", HTMLElement);
  leaveField(panel);
  for (const field of panel.querySelectorAll("input[data-typing]")) field.removeAttribute("data-typing");
  const share = byId("symmetrise-share", HTMLInputElement);
  share.value = share.defaultValue;
  // A tab that is chosen begins at its top.
  if (!staysHere) byId("tab-shape", HTMLButtonElement).click();
}

/**
 * What was typed for the face before is nothing to search or set on this one: it is left without being entered.
 *
 * @param {HTMLElement} panel
 */
function leaveField(panel) {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement) || !panel.contains(field)) return;
  const swallow = (/** @type {Event} */ event) => event.stopImmediatePropagation();
  addEventListener("change", swallow, true);
  field.blur();
  removeEventListener("change", swallow, true);
}
