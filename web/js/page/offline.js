import { listHash } from "./integrity.js";
import { scriptUrl } from "./trusted.js";

/** Maximum wait for the server if a stored copy is already in use. */
const TIMEOUT_MS = 5000;

/**
 * Stores the page for offline use. Resolves when it is stored, or cannot be.
 *
 * @param {boolean} needsFallback also store the WebGL2 module
 */
export async function storeOffline(needsFallback) {
  if (!("serviceWorker" in navigator)) return;
  // Offline use is optional, so errors are ignored.
  const stored = store(needsFallback).catch(() => {});
  await (navigator.serviceWorker.controller ? Promise.race([stored, timeout()]) : stored);
}

/** @param {boolean} needsFallback */
async function store(needsFallback) {
  const registration = await navigator.serviceWorker.register(scriptUrl("service-worker.js"));
  if (!registration) return;
  await installed(registration);
  const { active } = registration;
  if (needsFallback) active?.postMessage({ type: "keep-fallback" });
  if (active && !navigator.serviceWorker.controller) await Promise.race([takeControl(active), timeout()]);
}

function timeout() {
  return new Promise((resolve) => setTimeout(resolve, TIMEOUT_MS));
}

/** @param {ServiceWorkerRegistration} registration */
function installed({ installing: worker, active }) {
  return new Promise((resolve) => {
    if (!worker) return resolve(undefined);
    worker.addEventListener("statechange", () => {
      // A new version waits while another one is in use.
      const isDone = worker.state === "activated" || worker.state === "redundant" || (active && worker.state === "installed");
      if (isDone) resolve(undefined);
    });
  });
}

/**
 * Lets the service worker control this page, although the page was opened without it.
 *
 * @param {ServiceWorker} worker
 */
async function takeControl(worker) {
  const version = document.querySelector("meta[name='version']")?.getAttribute("content");
  const controlled = new Promise((resolve) => navigator.serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
  worker.postMessage({ type: "opened", build: { version, list: listHash() } });
  await controlled;
}
