import * as forWebGpu from "../../wasm/rosto-studio-web.js";
import { filesBase } from "../files.js";
import { verifiedModule } from "../page/integrity.js";
import { asPageError } from "../page/page-error.js";

/**
 * The page's module has two builds: one for WebGPU, and a larger one for WebGL2, which only browsers without WebGPU
 * download. Both export the same API.
 *
 * @typedef {import("../../wasm/rosto-studio-web.js").Studio} Studio
 * @typedef {(from: { module_or_path: WebAssembly.Module }) => Promise<unknown>} Instantiate
 * @typedef {Pick<typeof forWebGpu, "createRenderer" | "start"> & { default: Instantiate }} StudioModule
 */

/** Errors after which the canvas is still free for WebGL2. */
const NO_WEBGPU_CODES = new Set(["no-webgpu", "no-adapter", "no-device"]);

/** @type {StudioModule} */
let current = forWebGpu;
/** Compiled once, for all instances. @type {WebAssembly.Module | undefined} */
let compiled;
/** Number of restarts that work without a network. */
const SPARES = 3;
/** Fresh copies of the module's script, fetched in advance. @type {Promise<StudioModule>[]} */
const spares = [];
let spareCount = 0;

/** Whether the current module has trapped and no new instance exists yet. */
let hasTrapped = false;

/** Module of the current instance. Throws `{code: "restarting", …}` between a trap and the next instance. */
export function studioModule() {
  if (hasTrapped) throw restartingError();
  return current;
}

/** Blocks calls into the current module from now on. */
export function markTrapped() {
  hasTrapped = true;
}

/** The error thrown between a trap and the next instance. */
export function restartingError() {
  return { code: "restarting", message: "the module is restarting", hint: "" };
}

/**
 * Detaches a JS wrapper from its wasm object without a call into the trapped instance, also on garbage collection. The
 * memory is freed with the instance.
 *
 * @param {object} object
 */
export function detach(object) {
  /** @type {{ __destroy_into_raw?: () => number }} */ (object).__destroy_into_raw?.();
}

/** Whether the page draws with WebGL2. */
export function isFallback() {
  return fallback;
}

let fallback = false;
/** Whether a studio uses the WebGPU module, so that later ones do, too. */
let isWebGpuInUse = false;
/** @type {Promise<unknown>} */
let lastOpening = Promise.resolve();

/**
 * Opens a studio on the canvas. Throws `{code: "no-webgl", …}` without WebGPU and WebGL2. Calls run one after the
 * other, because the first one decides the module for all.
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
  if (fallback) return startStudio(canvas);
  if ("gpu" in navigator) {
    try {
      const studio = await startStudio(canvas);
      isWebGpuInUse = true;
      return studio;
    } catch (error) {
      if (isWebGpuInUse || !NO_WEBGPU_CODES.has(asPageError(error).code)) throw error;
    }
  }
  fallback = true;
  compiled = undefined;
  current = await loaded(import("../../wasm/rosto-studio-webgl.js"));
  return startStudio(canvas);
}

/**
 * Whether the module has trapped. The glue code reports objects that a trap left borrowed as an error from
 * `wbindgen_throw`.
 *
 * @param {unknown} error
 * @returns {error is Error}
 */
export function isTrap(error) {
  return error instanceof WebAssembly.RuntimeError || (error instanceof Error && /wbindgen_throw/.test(error.stack ?? ""));
}

/** Fetches spare modules, so that a restart needs no network. */
export async function prepareRestart() {
  while (spares.length < SPARES) spares.push(importFreshModule());
  await Promise.allSettled(spares);
}

/** A distinct URL makes the browser create a new module instance, with its own memory. */
function importFreshModule() {
  spareCount += 1;
  /** @type {Promise<StudioModule>} */
  const fresh = import(/* @vite-ignore */ /* webpackIgnore: true */ `${scriptFolder()}${moduleName()}.js?again=${spareCount}`);
  fresh.catch(() => {});
  return fresh;
}

/** Folder of the modules' scripts. */
function scriptFolder() {
  const base = filesBase();
  return base === undefined ? "../../wasm/" : `${base}wasm/`;
}

/** @type {Promise<void> | undefined} */
let replacing;

/**
 * Opens a studio in a new instance after a trap. Concurrent calls share the new instance.
 *
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<Studio>}
 */
export async function restartStudio(canvas) {
  replacing ??= replaceInstance().finally(() => (replacing = undefined));
  await replacing;
  if (fallback) await resetContext(canvas);
  return current.start(canvas);
}

async function replaceInstance() {
  current = await loaded(spares.shift() ?? importFreshModule());
  await loaded(instantiate());
  hasTrapped = false;
}

/** @param {HTMLCanvasElement} canvas */
async function startStudio(canvas) {
  await loaded(instantiate());
  return current.start(canvas);
}

async function instantiate() {
  const defaultUrl = new URL(`../../wasm/${moduleName()}_bg.wasm`, import.meta.url);
  compiled ??= await verifiedModule(`wasm/${moduleName()}_bg.wasm`, defaultUrl);
  await current.default({ module_or_path: compiled });
}

function moduleName() {
  return fallback ? "rosto-studio-webgl" : "rosto-studio-web";
}

/**
 * Replaces the canvas's WebGL2 context, which holds state of the trapped instance.
 *
 * @param {HTMLCanvasElement} canvas
 */
function resetContext(canvas) {
  const extension = canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context");
  if (!extension) return Promise.resolve();
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
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

/**
 * Reports a failed import or fetch as `not-loaded`.
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
