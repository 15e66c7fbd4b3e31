import * as forWebGpu from "../../wasm/rosto-studio-web.js";
import { filesBase } from "../files.js";
import { builtModule } from "../page/built.js";
import { asPageError } from "../page/page-error.js";

/**
 * The page's module is built twice: for WebGPU, and for WebGL2 as a larger one, which only browsers without WebGPU
 * download. Both have the same face to the page.
 *
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {(from: { module_or_path: WebAssembly.Module }) => Promise<unknown>} Instantiate
 * @typedef {Pick<typeof forWebGpu, "createRenderer" | "FileChoices" | "reopenGlb" | "reopenProject" | "sniffFile" | "solidRangeMm" | "start" | "usualDensity"> & { default: Instantiate }} StudioModule
 */

/** What keeps a browser from WebGPU; its canvas is still free then. */
const WITHOUT_WEBGPU = new Set(["no-webgpu", "no-adapter", "no-device"]);

/** @type {StudioModule} */
let inUse = forWebGpu;
/**
 * Fetched and compiled once, for as many instances as there will be.
 *
 * @type {WebAssembly.Module | undefined}
 */
let compiled;
/** As many instances in a row are at hand without a network. */
const SPARES = 3;
/**
 * The scripts of the module once more, each as new as on the first day; fetched before they are needed.
 *
 * @type {Promise<StudioModule>[]}
 */
const spares = [];
let spareCount = 0;

/** Whether the module in use has trapped and no other has come yet. */
let hasTrapped = false;

/**
 * The module that the studio runs in; whatever else is asked of the module is asked of this one. After a trap
 * `{code: "restarting", …}` is thrown until another instance is there.
 */
export function studioModule() {
  if (hasTrapped) throw restarting();
  return inUse;
}

/** From now on nothing is asked of the module in use. */
export function noteTrap() {
  hasTrapped = true;
}

/** What is thrown to whoever asks between a trap and the next instance. */
export function restarting() {
  return { code: "restarting", message: "the module is being started again", hint: "" };
}

/**
 * Gives back what was made for one call.
 *
 * @param {{ free: () => void }} object
 */
export function release(object) {
  if (hasTrapped) disown(object);
  else object.free();
}

/**
 * Forgets an object of an instance that has trapped, without a call into it: its memory goes with the instance. Nor does
 * the module's glue call into it when the object is collected.
 *
 * @param {object} object
 */
export function disown(object) {
  /** @type {{ __destroy_into_raw?: () => number }} */ (object).__destroy_into_raw?.();
}

/** Whether the page draws through WebGL2. */
export function isFallback() {
  return fallback;
}

let fallback = false;
/** Whether a studio runs in the module for WebGPU: whatever is opened later runs there, too. */
let isChosen = false;
/** @type {Promise<unknown>} */
let lastOpening = Promise.resolve();

/**
 * Opens a studio on the canvas; throws `{code: "no-webgl", …}` where there is neither WebGPU nor WebGL2. Several on a page are
 * opened one after the other: the first decides on the module for all.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<Studio>}
 */
export function openStudio(canvas) {
  const opened = lastOpening.then(() => open(canvas));
  lastOpening = opened.catch(() => {});
  return opened;
}

/** @param {HTMLCanvasElement} canvas */
async function open(canvas) {
  if (fallback) return started(canvas);
  if ("gpu" in navigator) {
    try {
      const studio = await started(canvas);
      isChosen = true;
      return studio;
    } catch (error) {
      if (isChosen || !WITHOUT_WEBGPU.has(asPageError(error).code)) throw error;
    }
  }
  fallback = true;
  compiled = undefined;
  inUse = await loaded(import("../../wasm/rosto-studio-webgl.js"));
  return started(canvas);
}

/**
 * Whether the module's memory is in an unknown state. After a trap the objects that were in use then are locked for ever,
 * which is an error and no trap: the module's glue throws it.
 *
 * @param {unknown} error
 * @returns {error is Error}
 */
export function isTrap(error) {
  return error instanceof WebAssembly.RuntimeError || (error instanceof Error && /wbindgen_throw/.test(error.stack ?? ""));
}

/** Fetches what starting again needs, so that it then needs no network. */
export async function prepareRestart() {
  while (spares.length < SPARES) spares.push(anotherModule());
  await Promise.allSettled(spares);
}

/** Another address is another instance, with memory of its own. */
function anotherModule() {
  spareCount += 1;
  /** @type {Promise<StudioModule>} */
  const another = import(/* @vite-ignore */ /* webpackIgnore: true */ `${scriptFolder()}${moduleName()}.js?again=${spareCount}`);
  another.catch(() => {});
  return another;
}

/** Where the modules' scripts lie as they were built. */
function scriptFolder() {
  const base = filesBase();
  return base === undefined ? "../../wasm/" : `${base}wasm/`;
}

/** @type {Promise<void> | undefined} */
let renewing;

/**
 * Opens a studio in a new instance of the module, after the one in use has trapped. Of several that were in it each gets one
 * in the same new instance.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<Studio>}
 */
export async function restartStudio(canvas) {
  renewing ??= renew().finally(() => (renewing = undefined));
  await renewing;
  if (fallback) await freshContext(canvas);
  return inUse.start(canvas);
}

async function renew() {
  inUse = await loaded(spares.shift() ?? anotherModule());
  await loaded(instantiate());
  hasTrapped = false;
}

/** @param {HTMLCanvasElement} canvas */
async function started(canvas) {
  await loaded(instantiate());
  return inUse.start(canvas);
}

async function instantiate() {
  const usual = new URL(`../../wasm/${moduleName()}_bg.wasm`, import.meta.url);
  compiled ??= await builtModule(`wasm/${moduleName()}_bg.wasm`, usual);
  await inUse.default({ module_or_path: compiled });
}

function moduleName() {
  return fallback ? "rosto-studio-webgl" : "rosto-studio-web";
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
    throw asPageError(error, "not-loaded");
  }
}
