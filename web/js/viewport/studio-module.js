import * as forWebGpu from "../../wasm/rosto-studio-web.js";
import { asTrouble } from "../page/notice.js";

/**
 * The page's module is built twice: for WebGPU, and for WebGL2 as a larger one, which only browsers without WebGPU
 * download. Both have the same face to the page.
 *
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {Pick<typeof forWebGpu, "createRenderer" | "reopenGlb" | "start"> & { default(): Promise<unknown> }} StudioModule
 */

/** What keeps a browser from WebGPU; its canvas is still free then. */
const WITHOUT_WEBGPU = new Set(["no-webgpu", "no-adapter", "no-device"]);

/** @type {StudioModule} */
let inUse = forWebGpu;

/** The module that the studio runs in; whatever else is asked of the module is asked of this one. */
export function studioModule() {
  return inUse;
}

/** Whether the page draws through WebGL2. */
export function isFallback() {
  return inUse !== forWebGpu;
}

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
  inUse = await import("../../wasm/rosto-studio-webgl.js");
  return started(canvas);
}

/** @param {HTMLCanvasElement} canvas */
async function started(canvas) {
  await inUse.default();
  return inUse.start(canvas);
}
