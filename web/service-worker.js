/**
 * Keeps the page usable without a network after the first visit: its files are stored when it is installed, and used
 * only when the network does not answer, so a new version is never hidden by an old copy. The module that draws through
 * WebGL2 is stored for the browsers that use it.
 */
const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/** @type {{ version: string, files: string[], fallback: string[] }} written by list-for-offline.mjs when the page is built */
const OFFLINE = { version: "unbuilt", files: [], fallback: [] };

const CACHE = `rosto-${OFFLINE.version}`;

worker.addEventListener("install", (event) => {
  event.waitUntil(store());
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(dropOldCaches());
});

worker.addEventListener("message", (event) => {
  if (event.data === "keep-fallback") event.waitUntil(storeFallback());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method === "GET" && request.url.startsWith(worker.registration.scope)) event.respondWith(answer(request));
});

async function store() {
  const cache = await caches.open(CACHE);
  await cache.addAll(OFFLINE.files);
  await worker.skipWaiting();
}

async function storeFallback() {
  const cache = await caches.open(CACHE);
  const stored = await Promise.all(OFFLINE.fallback.map((file) => cache.match(file)));
  if (!stored.every(Boolean)) await cache.addAll(OFFLINE.fallback);
}

async function dropOldCaches() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith("rosto-") && name !== CACHE).map((name) => caches.delete(name)));
}

/** @param {Request} request */
async function answer(request) {
  try {
    return await fetch(request);
  } catch (error) {
    const cache = await caches.open(CACHE);
    const stored = await cache.match(request, { ignoreSearch: true });
    if (stored) return stored;
    throw error;
  }
}
