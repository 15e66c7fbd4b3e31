import { byId } from "../../src/dom.ts";

/**
 * Resets the panel when another face opens: unfinished input, tab and scroll position.
 *
 * @param {boolean} keepTab keep the tab, because the user chose another face of the same visit
 */
export function resetPanel(keepTab) {
  const panel = byId("panel", HTMLElement);
  leaveField(panel);
  // Choosing a tab scrolls to its top.
  if (!keepTab) byId("tab-shape", HTMLButtonElement).click();
}

/** Blurs the focused field without its change event, which would edit the new face. @param {HTMLElement} panel */
function leaveField(panel) {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement) || !panel.contains(field)) return;
  const suppress = (/** @type {Event} */ event) => event.stopImmediatePropagation();
  addEventListener("change", suppress, true);
  field.blur();
  removeEventListener("change", suppress, true);
}
