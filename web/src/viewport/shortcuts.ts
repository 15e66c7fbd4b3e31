import { isComposing, isTyping } from "../page/dom.ts";
import type { Host } from "./host.ts";
import type { Key } from "../../wasm/rosto-studio-web.js";

/**
 * Sets up the keys that the session lists, on the whole page or in an element.
 *
 * @param onKey is called with the id of a pressed key
 */
export function setUpKeys(host: Host, root: EventTarget = window, onKey: (id: string) => void = () => {}) {
  const press = (event: KeyboardEvent) => {
    const isCancelling = event.key === "Escape";
    const isElsewhere = isTyping(event) || (root === window && document.querySelector("dialog[open]") !== null);
    for (const { id, place } of host.catalogue.keys.filter((key) => isPressed(key, event))) {
      const isOnCanvas = place === "canvas";
      if (isOnCanvas ? event.target !== host.canvas : isElsewhere && !isCancelling) continue;
      // Other parts of the page follow Escape too.
      if (isOnCanvas || !isCancelling) event.preventDefault();
      onKey(id);
      host.applyShown({ push: id });
    }
  };
  root.addEventListener("keydown", (event) => event instanceof KeyboardEvent && press(event), { signal: host.closed });
}

function isPressed({ key, with: held }: Key, event: KeyboardEvent) {
  const [hasCtrl, { altKey, shiftKey }] = [event.ctrlKey || event.metaKey, event];
  const isHeld = {
    nothing: !hasCtrl && !altKey,
    alt: !hasCtrl && altKey,
    ctrl: hasCtrl && !altKey && !shiftKey,
    "ctrl-shift": hasCtrl && !altKey && shiftKey,
  }[held];
  return isHeld && !isComposing(event) && (event.key === key || event.key.toLowerCase() === key);
}
