import { isFallback } from "../studio-module.ts";

/**
 * Clears pending WebGL errors and returns a function that throws if a new one has occurred. WebGL2 does not throw when
 * it runs out of memory.
 */
export function watchWebGl(canvas: HTMLCanvasElement) {
  const context = isFallback() ? canvas.getContext("webgl2") : null;
  while (context && !context.isContextLost() && context.getError() !== context.NO_ERROR);
  return () => {
    if (!context) return;
    if (context.isContextLost()) throw { code: "not-drawn", message: "the WebGL2 context was lost", hint: "" };
    const error = context.getError();
    if (error === context.OUT_OF_MEMORY) throw { code: "no-memory", message: "WebGL2 ran out of memory for the picture", hint: "" };
    if (error !== context.NO_ERROR) throw { code: "not-drawn", message: `WebGL2 error ${error}`, hint: "" };
  };
}
