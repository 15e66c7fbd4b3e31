import * as forWebGpu from "../../wasm/rosto-studio-web.js";
import { asTrouble } from "../page/notice.js";

/**
 * The page's module is built twice: for WebGPU, and for WebGL2 as a larger one, which only browsers without WebGPU
 * download. Both have the same face to the page.
 *
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {{ (from?: { module_or_path: WebAssembly.Module }): Promise<unknown>, __wbindgen_wasm_module?: WebAssembly.Module }} Instantiate
 * @typedef {Pick<typeof forWebGpu, "createRenderer" | "reopenGlb" | "reopenProject" | "sniffFile" | "start"> & { default: Instantiate }} StudioModule
 */

/** What keeps a browser from WebGPU; its canvas is still free then. */
const WITHOUT_WEBGPU = new Set(["no-webgpu", "no-adapter", "no-device"]);

/** @type {StudioModule} */
let inUse = forWebGpu;
/** The scripts of the module once more, each as new as on the first day; fetched before they are needed. */
let spares = 0;
/** @type {Promise<StudioModule> | undefined} */
let spare;

/** The module that the studio runs in; whatever else is asked of the module is asked of this one. */
export function studioModule() {
  return inUse;
}

/** Whether the page draws through WebGL2. */
export function isFallback() {
  return fallback;
}

let fallback = false;

/**
 * Opens a studio on the canvas; throws `{code: "no-webgl", …}` where there is neither WebGPU nor WebGL2.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<Studio>}
 */
export async function openStudio(canvas) {
  if ("gpu" in navigator) {
    try {
      return await started(canvas);
    } catch (error) {
      if (!WITHOUT_WEBGPU.has(asTrouble(error).code)) throw error;
    }
  }
  fallback = true;
  inUse = await loaded(import("../../wasm/rosto-studio-webgl.js"));
  return started(canvas);
}

/** Fetches what starting again needs, so that it then needs no network. */
export async function prepareRestart() {
  spares += 1;
  const name = fallback ? "rosto-studio-webgl" : "rosto-studio-web";
  // Another address is another instance, with memory of its own.
  spare = import(`../../wasm/${name}.js?again=${spares}`);
  await spare.catch(() => {});
}

/**
 * Opens a studio in a new instance of the module, after the one in use has trapped.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<Studio>}
 */
export async function restartStudio(canvas) {
  const compiled = inUse.default.__wbindgen_wasm_module;
  if (!spare) prepareRestart();
  inUse = await loaded(/** @type {Promise<StudioModule>} */ (spare));
  spare = undefined;
  await loaded(inUse.default(compiled && { module_or_path: compiled }));
  if (fallback) await freshContext(canvas);
  prepareRestart();
  return inUse.start(canvas);
}

/** @param {HTMLCanvasElement} canvas */
async function started(canvas) {
  await loaded(inUse.default());
  return inUse.start(canvas);
}

/**
 * What the instance that trapped has left in the canvas' WebGL2 context goes with the context.
 *
 * @param {HTMLCanvasElement} canvas
 */
function freshContext(canvas) {
  const extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
  if (!extension) return Promise.resolve();
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    // Whoever else hears of it need not get the context back: that is done here.
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

/**
 * A part of the page that may fail to come.
 *
 * @template T
 * @param {Promise<T>} part
 */
async function loaded(part) {
  try {
    return await part;
  } catch (error) {
    throw { code: "not-loaded", message: String(error), hint: "" };
  }
}
