/** Element with this id; throws unless it has the expected type. */
export function byId<T extends Element>(id: string, type: new () => T): T {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`no ${type.name} with id "${id}"`);
  return element;
}

/** Creates an element with a class and its content. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", ...content: (Node | string)[]) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...content);
  return element;
}

/** Creates a decorative icon from the page's SVG symbols. */
export function makeIcon(name: string) {
  const [icon, use] = ["svg", "use"].map((tag) => document.createElementNS("http://www.w3.org/2000/svg", tag)) as [SVGElement, SVGElement];
  icon.setAttribute("aria-hidden", "true");
  use.setAttribute("href", `#icon-${name}`);
  icon.append(use);
  return icon;
}

/** Types of inputs with text. */
const TEXT = new Set(["text", "search", "email", "url", "tel", "password", "number"]);

/** Whether an event edits text, or chooses from a list by its first letters. */
export function isTyping(event: Event) {
  const { target } = event;
  const isKey = event instanceof KeyboardEvent;
  if (isKey && event.isComposing) return true;
  if (target instanceof HTMLSelectElement) return isKey && !event.ctrlKey && !event.metaKey;
  // A number field has a text only while it is typed in: see slider.ts.
  if (target instanceof HTMLInputElement) return "typing" in target.dataset || (TEXT.has(target.type) && !("number" in target.dataset));
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

type Action = (event: MouseEvent) => void;

/** Actions by the name of their buttons. */
const actions = new Map<string, Set<Action>>();

/** Runs `action` when any button with `data-action="name"` is pressed, also a later one. */
export function onAction(name: string, action: Action) {
  if (actions.size === 0) document.addEventListener("click", perform);
  actions.set(name, (actions.get(name) ?? new Set()).add(action));
}

function perform(event: MouseEvent) {
  const button = event.target instanceof Element && event.target.closest<HTMLButtonElement>("button[data-action]");
  if (button) for (const action of actions.get(button.dataset["action"] ?? "") ?? []) action(event);
}

/** Enables the buttons of an action. */
export function enableAction(name: string, isEnabled: boolean) {
  for (const button of document.querySelectorAll<HTMLButtonElement>(`button[data-action="${name}"]`)) button.disabled = !isEnabled;
}
