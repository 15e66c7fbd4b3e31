import { ownScript } from "./trusted.js";

/** Where a copy is in use already, a server that is silent about a newer one keeps nobody waiting for longer. */
const PATIENCE_MS = 5000;

/**
 * Stores the page for use without a network. Resolves when that is done, or when it is clear that it will not be.
 *
 * @param {boolean} withFallback whether this browser needs the module that draws through WebGL2, which is stored later
 */
export async function keepOffline(withFallback) {
  if (!("serviceWorker" in navigator)) return;
  // Without it the page works all the same, as long as there is a network.
  const kept = keep(withFallback).catch(() => {});
  await (navigator.serviceWorker.controller ? Promise.race([kept, later()]) : kept);
}

/** @param {boolean} withFallback */
async function keep(withFallback) {
  const registration = await navigator.serviceWorker.register(ownScript("service-worker.js"));
  await installed(registration?.installing);
  if (withFallback) registration?.active?.postMessage("keep-fallback");
}

function later() {
  return new Promise((resolve) => setTimeout(resolve, PATIENCE_MS));
}

/** @param {ServiceWorker | null | undefined} worker being installed, if one is */
function installed(worker) {
  return new Promise((resolve) => {
    if (!worker) return resolve(undefined);
    worker.addEventListener("statechange", () => {
      if (worker.state === "activated" || worker.state === "redundant") resolve(undefined);
    });
  });
}
