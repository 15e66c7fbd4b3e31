import { asPageError } from "./page/page-error.ts";
import init, { catalogue, createRenderer, replaceInstance, start } from "../wasm/rosto-studio-web.js";
import type { Studio } from "../wasm/rosto-studio-web.js";
import { fetchFile, fileUrl } from "./files.ts";

/**
 * The page's module has two builds: one for WebGPU, and a larger one for WebGL2, which only browsers without WebGPU
 * download. Both export the same API.
 */
const forWebGpu = { default: init, createRenderer, replaceInstance, catalogue, start };
type StudioModule = Omit<typeof forWebGpu, "default"> & { default: (from: { module_or_path: Promise<Response> }) => Promise<unknown> };

/** Errors after which the canvas is still free for WebGL2. */
const NO_WEBGPU_CODES = new Set(["no-webgpu", "no-adapter", "no-device"]);

let current: StudioModule = forWebGpu;
/** Resolves once the current module has an instance. */
let instance: Promise<unknown> | undefined;
/** Whether the current instance has trapped and no new one exists yet. */
let hasTrapped = false;
let fallback = false;
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

/** Whether the page draws with WebGL2. */
export function isFallback() {
  return fallback;
}

/**
 * Whether the module has trapped. The glue code reports objects that a trap left borrowed as an error from
 * `wbindgen_throw`.
 */
export function isTrap(error: unknown): error is Error {
  return error instanceof WebAssembly.RuntimeError || (error instanceof Error && /wbindgen_throw/.test(error.stack ?? ""));
}

/**
 * Opens a studio on the canvas. Throws `{code: "no-webgl", …}` without WebGPU and WebGL2. Calls run one after the
 * other, because the first one decides the module for all.
 */
export function openStudio(canvas: HTMLCanvasElement): Promise<Studio> {
  const opened = lastOpening.then(() => open(canvas));
  lastOpening = opened.catch(() => {});
  return opened;
}

async function open(canvas: HTMLCanvasElement) {
  if (!fallback && "gpu" in navigator) {
    try {
      const studio = await startStudio(canvas);
      isWebGpuInUse = true;
      return studio;
    } catch (error) {
      if (isWebGpuInUse || !NO_WEBGPU_CODES.has(asPageError(error).code)) throw error;
    }
  }
  if (!fallback) [current, instance] = [await loaded(import("../wasm/rosto-studio-webgl.js")), undefined];
  fallback = true;
  return startStudio(canvas);
}

async function startStudio(canvas: HTMLCanvasElement) {
  await instantiate();
  return current.start(canvas);
}

/** Instantiates the current module, once; retries after a failure. */
function instantiate() {
  const forGpu = new URL("./rosto-studio-web_bg.wasm", import.meta.url);
  const forGl = new URL("./rosto-studio-webgl_bg.wasm", import.meta.url);
  instance ??= loaded(current.default({ module_or_path: fetchFile(fileUrl(fallback ? forGl : forGpu)) })).catch((error) => {
    instance = undefined;
    throw error;
  });
  return instance;
}

/** Opens a studio in a new instance after a trap, on the canvas of an earlier one. */
export async function restartStudio(canvas: HTMLCanvasElement) {
  if (hasTrapped) {
    current.replaceInstance();
    // The next call creates the instance.
    current.catalogue();
    hasTrapped = false;
  }
  if (fallback) await resetContext(canvas);
  return current.start(canvas);
}

/** Replaces the canvas's WebGL2 context, which holds state of the trapped instance. */
function resetContext(canvas: HTMLCanvasElement) {
  const extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
  if (!extension) return Promise.resolve();
  return new Promise<void>((resolve) => {
    // Hides both events from other listeners, because the context is restored here.
    const options = { once: true, capture: true };
    canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      event.stopImmediatePropagation();
      setTimeout(() => extension.restoreContext());
    }, options);
    canvas.addEventListener("webglcontextrestored", (event) => {
      event.stopImmediatePropagation();
      resolve();
    }, options);
    extension.loseContext();
  });
}

/** Reports a failed import or fetch as `not-loaded`. */
async function loaded<T>(part: Promise<T>) {
  try {
    return await part;
  } catch (error) {
    throw asPageError(error, "not-loaded");
  }
}
