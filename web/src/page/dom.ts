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

/** Creates a decorative icon. */
export function makeIcon(name: string) {
  const icon = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const use = document.createElementNS("http://www.w3.org/2000/svg", "use");
  icon.setAttribute("aria-hidden", "true");
  use.setAttribute("href", `${new URL("./icons.svg", import.meta.url)}#${name}`);
  icon.append(use);
  return icon;
}

/** Types of inputs with text. */
const TEXT = new Set(["text", "search", "email", "url", "tel", "password", "number"]);

/** Whether an event edits text, or chooses from a list by its first letters. */
export function isTyping(event: Event) {
  const { target } = event;
  const isKey = event instanceof KeyboardEvent;
  if (isKey && isComposing(event)) return true;
  if (target instanceof HTMLSelectElement) return isKey && !event.ctrlKey && !event.metaKey;
  // A number field has a text only while it is typed in: see slider.ts.
  if (target instanceof HTMLInputElement) return "typing" in target.dataset || (TEXT.has(target.type) && !("number" in target.dataset));
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

/** Whether a key belongs to an input method. Some browsers report the first one only by its code. */
export function isComposing({ isComposing, keyCode }: KeyboardEvent) {
  return isComposing || keyCode === 229;
}

/** The page, or the shadow root of an element. */
export type Root = Document | ShadowRoot;

/** Runs `action` when any button of `root` with `data-action="name"` is pressed, also a later one. */
export function onAction(name: string, action: (event: MouseEvent) => void, root: Root = document) {
  root.addEventListener("click", (event) => {
    const isMeant = event.target instanceof Element && event.target.closest(`button[data-action="${name}"]`);
    if (isMeant) action(event as MouseEvent);
  });
}

/** Enables the buttons of an action. */
export function enableAction(name: string, isEnabled: boolean, root: Root = document) {
  const buttons = root.querySelectorAll<HTMLButtonElement>(`button[data-action="${name}"]`);
  for (const button of buttons) button.disabled = !isEnabled;
}
