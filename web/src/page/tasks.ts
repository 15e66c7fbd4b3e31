/** Resolves in a new task, so that the browser can handle events and paint first. */
export function nextTask() {
  return new Promise<void>((resolve) => setTimeout(resolve));
}

/** Resolves after the next frame is painted. */
export function afterNextFrame() {
  return new Promise<void>((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
}
