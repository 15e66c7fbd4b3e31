/**
 * Service worker for offline use. One cache holds each version of the page, under the name of its folder. A version's
 * files never change, so they come from the caches first. The page itself comes from the network; after a timeout or an
 * error, from the newest complete cache.
 *
 * A cache is kept while a tab uses its version; tabs show that by a Web Lock. See offline.ts.
 */

/** Hashes by file name, from the build. */
declare const BUILD: { version: string; files: Record<string, string> };

const worker = self as unknown as ServiceWorkerGlobalScope;

/** Files for browsers without WebGPU, whose page adds a parameter to the address of this script. */
const FALLBACK = /^rosto-studio-webgl/;
const PREFIX = "rosto-";
const PAGE = "./";
const VERSION_FOLDER = /\/([0-9a-f]{16})\/[^/]+$/;
const TIMEOUT_MS = 3000;

worker.addEventListener("install", (event) => event.waitUntil(store()));

worker.addEventListener("activate", (event) => event.waitUntil(Promise.all([worker.clients.claim(), cleanUp()])));

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(worker.registration.scope)) return;
  const version = VERSION_FOLDER.exec(new URL(request.url).pathname)?.[1];
  if (version) event.respondWith(fileOf(version, request));
  else if (isPage(request)) {
    event.respondWith(pageFor(request));
    event.waitUntil(cleanUp());
  }
});

async function store() {
  const cache = await caches.open(PREFIX + BUILD.version);
  const page = await fetch(PAGE, { cache: "no-cache" });
  if (!(await page.clone().text()).includes(`${BUILD.version}/`)) throw new Error("the page has another version");
  const files = Object.entries(BUILD.files).filter(([name]) => location.search !== "" || !FALLBACK.test(name));
  const stored = files.map(([name, hash]) => storeFile(cache, `${BUILD.version}/${name}`, hash));
  await Promise.all(stored);
  // Last, as it marks the cache as complete.
  await cache.put(PAGE, page);
  await worker.skipWaiting();
}

/** Refuses a file that a host or a network has altered; another copy may be in the browser's cache. */
async function storeFile(cache: Cache, url: string, integrity: string) {
  const response = await fetch(url, { integrity }).catch(() => fetch(url, { integrity, cache: "reload" }));
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  await cache.put(url, response);
}

/** Names of the caches, oldest first; none if they cannot be read. */
async function versions() {
  return (await caches.keys().catch(() => [])).filter((name) => name.startsWith(PREFIX));
}

/** Deletes the caches of versions that no tab uses. */
async function cleanUp() {
  const { held = [] } = await navigator.locks.query();
  const used = new Set([PREFIX + BUILD.version, ...held.map(({ name }) => name)]);
  for (const name of await versions()) if (!used.has(name)) await caches.delete(name);
}

function isPage(request: Request) {
  const { pathname } = new URL(request.url);
  const scope = new URL(worker.registration.scope).pathname;
  return request.mode === "navigate" && (pathname === scope || pathname === `${scope}index.html`);
}

async function pageFor(request: Request) {
  const stored = await storedPage();
  if (!stored) return fetch(request);
  try {
    const response = await fetch(request, { signal: AbortSignal.timeout(TIMEOUT_MS) });
    // Completely, as the network may stop halfway.
    await response.clone().text();
    // The browser follows a redirect itself.
    return response.ok || response.type === "opaqueredirect" ? response : stored;
  } catch {
    return stored;
  }
}

/** The page of the newest complete cache. */
async function storedPage() {
  for (const name of (await versions()).reverse()) {
    const page = await (await caches.open(name)).match(PAGE).catch(() => undefined);
    if (page) return page;
  }
  return undefined;
}

async function fileOf(version: string, request: Request) {
  const stored = await caches.match(request, { cacheName: PREFIX + version, ignoreVary: true }).catch(() => undefined);
  return stored ?? fetch(request);
}
