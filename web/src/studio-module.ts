import init, { catalogue, createRenderer, renew, replaceInstance, start } from "../wasm/rosto-studio-web.js";
import { fetchFile, fileUrl } from "./files.ts";
import { asPageError } from "./page/page-error.ts";
import { nextTask } from "./page/tasks.ts";
import type { Studio } from "../wasm/rosto-studio-web.js";

/**
 * The page's module has two builds: one for WebGPU, and a larger one for WebGL2, which only browsers without WebGPU
 * download. Both export the same API.
 */
const forWebGpu = { default: init, createRenderer, replaceInstance, renew, catalogue, start };
type StudioModule = Omit<typeof forWebGpu, "default"> & {
  default: (from: { module_or_path: Promise<Response> }) => Promise<unknown>;
};

/** Errors after which the canvas is still free for WebGL2. */
const NO_WEBGPU_CODES = new Set(["no-webgpu", "no-adapter", "no-device"]);

let current: StudioModule = forWebGpu;
/** Resolves once the current module has an instance. */
let instance: Promise<unknown> | undefined;
/** Whether the current instance has trapped and no new one exists yet. */
let hasTrapped = false;
/** Whether a studio uses the WebGPU module, so that later ones do, too. */
let isWebGpuInUse = false;
let lastOpening: Promise<unknown> = Promise.resolve();

/** The current module. Throws `{code: "restarting", …}` between a trap and the next instance. */
export function studioModule() {
  if (hasTrapped) throw restartingError();
  return current;
}

/** Blocks calls into the module until the next instance. */
export function markTrapped() {
  hasTrapped = true;
}

/** The error thrown between a trap and the next instance. */
export function restartingError() {
  return { code: "restarting", message: "the module is restarting", hint: "" };
}

/**
 * Whether the module has trapped. The glue code reports objects that a trap left borrowed as an error from
 * `wbindgen_throw`.
 */
export function isTrap(error: unknown): error is Error {
  return error instanceof WebAssembly.RuntimeError || (error instanceof Error && /wbindgen_throw/.test(error.stack ?? ""));
}

/**
 * Opens a studio on the canvas. Throws `{code: "no-webgl", …}` without WebGPU and WebGL2, and `{code: "not-loaded", …}`
 * if the module did not arrive; a later call requests it again. Calls run one after the other, because the first one
 * decides the module for all.
 */
export function openStudio(canvas: HTMLCanvasElement): Promise<Studio> {
  const opened = lastOpening.then(() => open(canvas));
  lastOpening = opened.catch(() => {});
  return opened;
}

async function open(canvas: HTMLCanvasElement) {
  if (!isFallback() && "gpu" in navigator) {
    try {
      const studio = await startStudio(canvas);
      isWebGpuInUse = true;
      return studio;
    } catch (error) {
      if (isWebGpuInUse || !NO_WEBGPU_CODES.has(asPageError(error).code)) throw error;
    }
  }
  if (!isFallback()) [current, instance] = [await loaded(import("../wasm/rosto-studio-webgl.js")), undefined];
  return startStudio(canvas);
}

/** Whether the page draws with WebGL2. */
export function isFallback() {
  return current !== forWebGpu;
}

async function startStudio(canvas: HTMLCanvasElement) {
  const forGpu = new URL("./rosto-studio-web_bg.wasm", import.meta.url);
  const forGl = new URL("./rosto-studio-webgl_bg.wasm", import.meta.url);
  instance ??= loaded(current.default({ module_or_path: fetchFile(fileUrl(isFallback() ? forGl : forGpu)) }));
  await instance.catch((error) => {
    instance = undefined;
    throw error;
  });
  return current.start(canvas);
}

/** Reports a failed import or fetch as `not-loaded`. */
function loaded<T>(part: Promise<T>) {
  return part.catch((error) => {
    throw asPageError(error, "not-loaded");
  });
}

/** Opens a studio in a new instance after a trap, on the canvas of an earlier one. */
export async function restartStudio(canvas: HTMLCanvasElement) {
  if (hasTrapped) {
    current.replaceInstance();
    current.renew();
    hasTrapped = false;
  }
  if (isFallback()) await resetContext(canvas);
  return current.start(canvas);
}

/** Replaces the canvas's WebGL2 context, which holds state of the trapped instance. */
async function resetContext(canvas: HTMLCanvasElement) {
  const extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
  if (!extension) return;
  const lost = takeEvent(canvas, "webglcontextlost");
  extension.loseContext();
  await lost;
  // The context can be restored once the event has been dispatched.
  await nextTask();
  const restored = takeEvent(canvas, "webglcontextrestored");
  extension.restoreContext();
  await restored;
}

/** Waits for an event, and hides it from other listeners. */
function takeEvent(canvas: HTMLCanvasElement, name: string) {
  return new Promise<void>((resolve) => {
    const take = (event: Event) => {
      event.preventDefault();
      event.stopImmediatePropagation();
      resolve();
    };
    canvas.addEventListener(name, take, { once: true, capture: true });
  });
}

/**
 * Clears pending WebGL errors and returns a function that throws if a new one has occurred. WebGL2 does not throw when
 * it runs out of memory.
 */
export function watchWebGl(canvas: HTMLCanvasElement) {
  const context = isFallback() ? canvas.getContext("webgl2") : null;
  while (context && !context.isContextLost() && context.getError() !== context.NO_ERROR);
  return () => {
    if (!context) return;
    const error = context.isContextLost() ? context.CONTEXT_LOST_WEBGL : context.getError();
    if (error === context.NO_ERROR) return;
    const code = error === context.OUT_OF_MEMORY ? "no-memory" : "not-drawn";
    throw { code, message: `WebGL2 error ${error}`, hint: "" };
  };
}
