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
 * Whether key presses edit text or an unfinished number (`data-typing`).
 *
 * @param {EventTarget | null} target
 */
export function isTyping(target) {
  return target instanceof HTMLInputElement && (target.type === "text" || "typing" in target.dataset);
}

/**
 * Colour of a colour input, channels 0 to 255.
 *
 * @param {HTMLInputElement} input of type color
 */
export function chosenColour(input) {
  const value = parseInt(input.value.slice(1), 16);
  return { red: (value >> 16) & 255, green: (value >> 8) & 255, blue: value & 255 };
}

/**
 * Formats a colour for a colour input.
 *
 * @param {Iterable<number>} channels 0 to 255 each
 */
export function hex(channels) {
  return `#${[...channels].map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

/**
 * Runs `action` when any element with `data-action="name"` is pressed.
 *
 * @param {string} name
 * @param {(event: MouseEvent) => void} action
 */
export function onAction(name, action) {
  for (const button of actionButtons(name)) button.addEventListener("click", action);
}

/**
 * @param {string} name
 * @param {boolean} enabled
 */
export function enableAction(name, enabled) {
  for (const button of actionButtons(name)) button.disabled = !enabled;
}

/** @param {string} name */
function actionButtons(name) {
  return /** @type {NodeListOf<HTMLButtonElement>} */ (document.querySelectorAll(`button[data-action="${name}"]`));
}
