import { scriptUrl } from "./trusted.ts";

/** Maximum wait for the server if a stored copy is already in use. */
const TIMEOUT_MS = 5000;

/** Files that only browsers without WebGPU download. */
const FALLBACK = /\/rosto-studio-webgl[^/]*$/;

/** Stores the page for offline use. Resolves when it is stored, or cannot be. */
export async function storeOffline() {
  if (!("serviceWorker" in navigator)) return;
  // Offline use is optional, so errors are ignored.
  const stored = store().catch(() => {});
  await (navigator.serviceWorker.controller ? Promise.race([stored, timeout()]) : stored);
}

async function store() {
  const { serviceWorker } = navigator;
  const registration = await serviceWorker.register(scriptUrl(new URL("../service-worker.js", import.meta.url)));
  await installed(registration);
  if (!registration.active) return;
  if (!serviceWorker.controller) await Promise.race([new Promise((resolve) => serviceWorker.addEventListener("controllerchange", resolve, { once: true })), timeout()]);
  // Again, through the service worker, which keeps them.
  const loaded = performance.getEntriesByType("resource").filter(({ name }) => FALLBACK.test(name));
  await Promise.all(loaded.map(async ({ name }) => (await fetch(name)).arrayBuffer()));
}

function timeout() {
  return new Promise((resolve) => setTimeout(resolve, TIMEOUT_MS));
}

function installed({ installing: worker }: ServiceWorkerRegistration) {
  return new Promise((resolve) => {
    if (!worker) return resolve(undefined);
    worker.addEventListener("statechange", () => ["activated", "redundant"].includes(worker.state) && resolve(undefined));
  });
}
