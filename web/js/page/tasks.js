/** Resolves in a task of its own, before which the page can answer and draw. */
export function nextTask() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => setTimeout(resolve));
}

/** Resolves once the next frame is on the screen. */
export function afterNextFrame() {
  return new Promise((/** @type {(value: void) => void} */ resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}
