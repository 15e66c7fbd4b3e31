/**
 * Element with this id; throws unless it has the expected type.
 *
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function byId(id, type) {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`no ${type.name} with id "${id}"`);
  return element;
}

/**
 * Creates an element with a class and text.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {string} [className]
 * @param {string} [text]
 */
export function make(tag, className, text) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  if (text !== undefined) element.textContent = text;
  return element;
}

/**
 * Creates a decorative icon from the page's SVG symbols.
 *
 * @param {string} name
 */
export function makeIcon(name) {
  const icon = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const use = document.createElementNS("http://www.w3.org/2000/svg", "use");
  icon.setAttribute("aria-hidden", "true");
  use.setAttribute("href", `#icon-${name}`);
  icon.append(use);
  return icon;
}

/**
 * Whether an event edits text, or chooses from a list by its first letters.
 *
 * @param {Event} event
 */
export function isTyping(event) {
  const { target } = event;
  const isKey = event instanceof KeyboardEvent;
  if (isKey && event.isComposing) return true;
  if (target instanceof HTMLSelectElement) return isKey && !event.ctrlKey && !event.metaKey;
  if (target instanceof HTMLInputElement) return "typing" in target.dataset || (TEXT.has(target.type) && !("number" in target.dataset));
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

/** Types of inputs with text. */
const TEXT = new Set(["text", "search", "email", "url", "tel", "password", "number"]);

/** Actions by the name of their buttons. @type {Map<string, Set<(event: MouseEvent) => void>>} */
const actions = new Map();

document.addEventListener("click", (event) => {
  const button = event.target instanceof Element && event.target.closest("button[data-action]");
  if (!(button instanceof HTMLButtonElement)) return;
  for (const action of actions.get(button.dataset["action"] ?? "") ?? []) action(event);
});

/**
 * Runs `action` when any button with `data-action="name"` is pressed, also a later one.
 *
 * @param {string} name
 * @param {(event: MouseEvent) => void} action
 */
export function onAction(name, action) {
  actions.set(name, (actions.get(name) ?? new Set()).add(action));
}

/**
 * @param {string} name
 * @param {boolean} enabled
 */
export function enableAction(name, enabled) {
  for (const button of document.querySelectorAll(`button[data-action="${name}"]`)) button.toggleAttribute("disabled", !enabled);
}
