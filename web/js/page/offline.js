import { listHash } from "./built.js";
import { ownScript } from "./trusted.js";

/** Where a copy is in use already, a server that is silent about a newer one keeps nobody waiting for longer. */
const PATIENCE_MS = 5000;

/**
 * Stores the page for use without a network. Resolves when that is done, or when it is clear that it will not be.
 *
 * @param {boolean} needsFallback whether this browser needs the module that draws through WebGL2, which is stored later
 */
export async function keepOffline(needsFallback) {
  if (!("serviceWorker" in navigator)) return;
  // Without it the page works all the same, as long as there is a network.
  const kept = keep(needsFallback).catch(() => {});
  await (navigator.serviceWorker.controller ? Promise.race([kept, later()]) : kept);
}

/** @param {boolean} needsFallback */
async function keep(needsFallback) {
  const registration = await navigator.serviceWorker.register(ownScript("service-worker.js"));
  if (!registration) return;
  await installed(registration);
  const { active } = registration;
  if (needsFallback) active?.postMessage({ type: "keep-fallback" });
  if (active && !navigator.serviceWorker.controller) await Promise.race([served(active), later()]);
}

function later() {
  return new Promise((resolve) => setTimeout(resolve, PATIENCE_MS));
}

/** @param {ServiceWorkerRegistration} registration */
function installed({ installing: worker, active }) {
  return new Promise((resolve) => {
    if (!worker) return resolve(undefined);
    worker.addEventListener("statechange", () => {
      // Where another version is in use, this one waits.
      const isDone = worker.state === "activated" || worker.state === "redundant" || (active && worker.state === "installed");
      if (isDone) resolve(undefined);
    });
  });
}

/**
 * Has this page's files come from the store from now on, though it was opened without one.
 *
 * @param {ServiceWorker} worker
 */
async function served(worker) {
  const version = document.querySelector("meta[name='version']")?.getAttribute("content");
  const isServed = new Promise((resolve) => navigator.serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
  worker.postMessage({ type: "opened", build: { version, list: listHash() } });
  await isServed;
}
