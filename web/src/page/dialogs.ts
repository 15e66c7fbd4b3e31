import { byId, isTyping, onAction } from "./dom.ts";

/** Sets up the credits and keyboard-shortcut dialogs. */
export function setUpDialogs() {
  setUp("credits");
  const keys = setUp("keys");
  addEventListener("keydown", (event) => {
    if (event.key === "?" && !isTyping(event) && !keys.open) keys.showModal();
  });
}

function setUp(name: string) {
  const dialog = byId(name, HTMLDialogElement);
  onAction(`open-${name}`, () => dialog.showModal());
  onAction(`close-${name}`, () => dialog.close());
  return dialog;
}
