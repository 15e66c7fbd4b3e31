import { byId } from "./dom.ts";

/**
 * Resets the panel when another face opens: unfinished input, tab and scroll position.
 *
 * @param keepTab keep the tab, because the user chose another face of the same visit
 */
export function resetPanel(keepTab: boolean) {
  const panel = byId("panel", HTMLElement);
  leaveField(panel);
  // Choosing a tab scrolls to its top.
  if (!keepTab) byId("tab-shape", HTMLButtonElement).click();
}

/** Blurs the focused field without its change event, which would edit the new face. */
function leaveField(panel: HTMLElement) {
  const field = document.activeElement;
  if (!(field instanceof HTMLInputElement) || !panel.contains(field)) return;
  const suppress = (event: Event) => event.stopImmediatePropagation();
  addEventListener("change", suppress, true);
  field.blur();
  removeEventListener("change", suppress, true);
}
