import { isFallback } from "./studio-module.ts";
import { scriptUrl } from "./trusted.ts";

/** Maximum wait for the server if a stored copy is already in use. */
const TIMEOUT_MS = 5000;

/** Folder of this build of the page, which names its content; undefined elsewhere. */
const VERSION = /\/([0-9a-f]{16})\/[^/]*$/.exec(import.meta.url)?.[1];

/** Shows the service worker that this tab uses its version: see service-worker.ts. */
export function useVersion() {
  if (!VERSION) return;
  let release = () => {};
  const untilReleased = () => new Promise<void>((resolve) => (release = resolve));
  const hold = () => navigator.locks?.request(`rosto-${VERSION}`, { mode: "shared" }, untilReleased);
  hold();
  // A page with a lock does not enter the back/forward cache.
  addEventListener("pagehide", () => release());
  addEventListener("pageshow", ({ persisted }) => persisted && hold());
}

/** Stores the page for offline use. Resolves when it is stored, or cannot be. */
export async function storeOffline() {
  if (!("serviceWorker" in navigator)) return;
  // Offline use is optional, so errors are ignored.
  const stored = store().catch(() => {});
  const timeout = new Promise((resolve) => setTimeout(resolve, TIMEOUT_MS));
  await (navigator.serviceWorker.controller ? Promise.race([stored, timeout]) : stored);
}

async function store() {
  // With this parameter, it also stores the module for browsers without WebGPU.
  const script = new URL(`../service-worker.js${isFallback() ? "?webgl2" : ""}`, import.meta.url);
  const { installing } = await navigator.serviceWorker.register(scriptUrl(script));
  if (!installing) return;
  await new Promise<void>((resolve) => {
    installing.addEventListener("statechange", () => /activated|redundant/.test(installing.state) && resolve());
  });
}
