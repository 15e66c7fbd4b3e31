import { byId, isTyping, make, onAction } from "./dom.ts";

/** Names of the rows of the key map, by who can use them. */
const KEYS = {
  "": ["point", "select", "turn", "move", "zoom", "reach"],
  "by-keys": ["axis", "fine", "cancel", "undo", "before", "views", "scene", "home", "wireframe", "help"],
  expert: ["pin"],
};

const CREDITS = ["networks", "canonical", "portrait", "validator", "rosto"];

/** Sets up the dialogs of keys and credits, whose rows are words. */
export function setUpDialogs() {
  const rows = Object.entries(KEYS).flatMap(([who, names]) => names.map((name) => row(`keys.${name}`, "does", who)));
  const keys = setUp("keys", rows);
  setUp("credits", CREDITS.map((name) => row(`credits.${name}`, "terms")));
  addEventListener("keydown", (event) => {
    if (event.key === "?" && !isTyping(event) && !keys.open) keys.showModal();
  });
}

function setUp(name: string, rows: HTMLElement[]) {
  const dialog = byId(name, HTMLDialogElement);
  dialog.querySelector("dl")?.append(...rows);
  onAction(`open-${name}`, () => dialog.showModal());
  onAction(`close-${name}`, () => dialog.close());
  return dialog;
}

/** A term and its description. {@link translatePage} writes the words. */
function row(key: string, suffix: string, who = "") {
  const [element, term, description] = [make("div", who), make("dt"), make("dd")];
  element.toggleAttribute("data-expert", who === "expert");
  [term.dataset["text"], description.dataset["text"]] = [key, `${key}.${suffix}`];
  element.append(term, description);
  return element;
}
