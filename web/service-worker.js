/**
 * Service worker for offline use. Caches the page's files on install, and the WebGL2 module for browsers that use it.
 *
 * There is one cache per version. Each client (page or worker) is recorded with the version it was opened in, and gets
 * the files of that version:
 * - Pages are network first. After a timeout or an error, the page comes from the cache.
 * - Other files are cache first. A file that is not cached is fetched and must match its hash in the page's integrity
 *   list; otherwise loading fails.
 *
 * After a deploy, the new service worker caches its files and waits until all pages are closed. Until then, the old one
 * serves the pages of both versions.
 */
const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/**
 * A page's version, and the hash of its integrity list, from its meta elements.
 *
 * @typedef {{ version: string, list: string }} Build
 */

/**
 * Replaced by list-for-offline.mjs in the build: integrity hashes by file name.
 *
 * @type {{ version: string, files: Record<string, string>, fallback: Record<string, string> }}
 */
const OFFLINE = { version: "unbuilt", files: {}, fallback: {} };

/** The page's URL in the cache. */
const PAGE = "./";

const LIST = "integrity.json";

const TIMEOUT_MS = 3000;

/** Cache of client records. They are persistent because the browser can stop a service worker at any time. */
const CLIENTS = "rosto-notes";

/** Number of latest records to keep for closed clients: a page that is being opened is not listed as a client yet. */
const SPARED_RECORDS = 20;

/** Verified by the page itself while streaming, see integrity.js. */
const CHECKED_BY_PAGE = /\.(wasm|onnx)$/;

/** Client records in memory. @type {Map<string, Build>} */
const builds = new Map();

worker.addEventListener("install", (event) => {
  event.waitUntil(cacheFiles());
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(cleanUp());
});

worker.addEventListener("message", (event) => {
  const { source, data } = event;
  if (data.type === "opened" && source instanceof Client) event.waitUntil(claimPage(source, data.build));
  if (data.type === "keep-fallback") event.waitUntil(cacheFallback());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(worker.registration.scope)) return;
  event.respondWith(isPage(request) ? respondWithPage(event) : respondWithFile(event));
});

async function cacheFiles() {
  const cache = await caches.open(cacheName(OFFLINE.version));
  const page = await fetch(PAGE, { cache: "no-cache" });
  if ((await buildOf(page))?.version !== OFFLINE.version) throw new Error("the page and the service worker have different versions");
  await cache.addAll(Object.entries(OFFLINE.files).map(verifiedRequest));
  // A browser that used the fallback in an earlier version needs it again.
  const cached = await Promise.all(Object.keys(OFFLINE.fallback).map((file) => caches.match(file)));
  if (cached.some(Boolean)) await cacheFallback();
  // Last, as it marks the cache as complete.
  await cache.put(PAGE, page);
}

async function cacheFallback() {
  const cache = await caches.open(cacheName(OFFLINE.version));
  const files = Object.entries(OFFLINE.fallback);
  const cached = await Promise.all(files.map(([file]) => cache.match(file)));
  if (!cached.every(Boolean)) await cache.addAll(files.map(verifiedRequest));
}

/**
 * A request that fails if the response is not the built file: from the HTTP cache of an earlier version, from a server
 * during a deploy, or altered in transit.
 *
 * @param {[string, string]} entry
 */
function verifiedRequest([file, integrity]) {
  return new Request(file, { cache: "no-cache", integrity });
}

/** Deletes the caches of versions without an open client, and the records of closed clients. */
async function cleanUp() {
  const open = await worker.clients.matchAll({ type: "all", includeUncontrolled: true });
  const openBuilds = await Promise.all(open.map(({ id }) => buildOfClient(id)));
  const needed = new Set([CLIENTS, cacheName(OFFLINE.version), ...openBuilds.map((build) => build && cacheName(build.version))]);
  const names = (await caches.keys()).filter((name) => name.startsWith("rosto-") && !needed.has(name));
  await Promise.all(names.map((name) => caches.delete(name)));
  const cache = await caches.open(CLIENTS);
  const older = (await cache.keys()).slice(0, -SPARED_RECORDS);
  const closed = older.filter(({ url }) => !open.some(({ id }) => url.endsWith(`/${id}`)));
  await Promise.all(closed.map((request) => cache.delete(request)));
}

/**
 * Starts to control a page that was opened without a service worker.
 *
 * @param {Client} page
 * @param {Build} build
 */
async function claimPage({ id }, build) {
  await recordClient(id, build);
  await worker.clients.claim();
}

/** @param {Request} request */
function isPage(request) {
  const { pathname } = new URL(request.url);
  const scope = new URL(worker.registration.scope).pathname;
  return request.mode === "navigate" && (pathname === scope || pathname === `${scope}index.html`);
}

/** @param {FetchEvent} event */
async function respondWithPage({ request, resultingClientId }) {
  const own = await readCache(cacheName(OFFLINE.version), PAGE);
  const fresh = own ? await fetchInTime(request) : await fetch(request);
  const pages = [fresh, await newestPage(), own].filter((page) => page !== undefined);
  const last = /** @type {Response} */ (pages.pop());
  for (const page of pages) {
    const build = await buildOf(page);
    if (!build || (await recordClient(resultingClientId, build))) return page;
  }
  // On a full disk, the client cannot be recorded, and an unrecorded client gets the files of this version.
  const build = await buildOf(last);
  if (build) await recordClient(resultingClientId, build);
  return last;
}

/** The page of the newest complete cache. */
async function newestPage() {
  const names = (await caches.keys().catch(() => [])).filter((name) => name.startsWith("rosto-") && name !== CLIENTS);
  for (const name of names.reverse()) {
    const page = await readCache(name, PAGE);
    if (page) return page;
  }
  return undefined;
}

/**
 * Fetches a response completely; undefined after a timeout or an error.
 *
 * @param {Request} request
 */
async function fetchInTime(request) {
  const controller = new AbortController();
  const timer = setTimeout(() => controller.abort(), TIMEOUT_MS);
  try {
    const response = await fetch(request, { signal: controller.signal });
    await response.clone().text();
    // The browser follows a redirect itself.
    return response.ok || response.type === "opaqueredirect" ? response : undefined;
  } catch {
    return undefined;
  } finally {
    clearTimeout(timer);
  }
}

/**
 * @param {Response} page
 * @returns {Promise<Build | undefined>} undefined if it is not a page of Rosto
 */
async function buildOf(page) {
  const text = await page.clone().text();
  const meta = (/** @type {string} */ name) => new RegExp(`<meta name="${name}" content="([^"]+)">`).exec(text)?.[1];
  const [version, list] = [meta("version"), meta("integrity")];
  return version && list ? { version, list } : undefined;
}

/** @param {FetchEvent} event */
async function respondWithFile({ request, clientId, resultingClientId }) {
  const build = await buildOfClient(clientId);
  // A worker has the version of the page that starts it.
  if (build && resultingClientId) await recordClient(resultingClientId, build);
  const cached = await readCache(cacheName(build?.version ?? OFFLINE.version), request);
  return cached ?? (build ? fetchVerified(build, request) : fetch(request));
}

/**
 * Fetches a file of a build that is not in the cache.
 *
 * @param {Build} build
 * @param {Request} request
 */
async function fetchVerified(build, request) {
  const { origin, pathname } = new URL(request.url);
  const name = `${origin}${pathname}`.slice(worker.registration.scope.length);
  if (name === LIST) return fetch(verifiedRequest([LIST, build.list]));
  const integrity = CHECKED_BY_PAGE.test(name) ? undefined : (await filesOf(build))[name];
  return integrity ? fetch(verifiedRequest([request.url, integrity])) : fetch(request);
}

/**
 * Integrity hashes of a build by file name.
 *
 * @param {Build} build
 * @returns {Promise<Record<string, string>>}
 */
async function filesOf({ version, list }) {
  const cached = await readCache(cacheName(version), LIST);
  const response = cached ?? (await fetch(verifiedRequest([LIST, list])));
  if (!cached) await writeCache(cacheName(version), LIST, response.clone());
  return (await response.json()).files;
}

/** @param {string} version */
function cacheName(version) {
  return `rosto-${version}`;
}

/**
 * Records the build of a page or worker.
 *
 * @param {string} client
 * @param {Build} build
 * @returns whether the record persists after the service worker stops
 */
function recordClient(client, build) {
  builds.set(client, build);
  return writeCache(CLIENTS, `./builds/${client}`, new Response(JSON.stringify(build)));
}

/**
 * @param {string} client
 * @returns {Promise<Build | undefined>} undefined without a record
 */
async function buildOfClient(client) {
  return builds.get(client) ?? (await (await readCache(CLIENTS, `./builds/${client}`))?.json());
}

/**
 * Treats an unreadable cache as empty.
 *
 * @param {string} name of the cache
 * @param {Request | string} request
 */
async function readCache(name, request) {
  try {
    const cache = await caches.open(name);
    return await cache.match(request, { ignoreSearch: true, ignoreVary: true });
  } catch {
    return undefined;
  }
}

/**
 * @param {string} name of the cache
 * @param {string} url
 * @param {Response} response
 * @returns false if the disk is full
 */
async function writeCache(name, url, response) {
  try {
    await (await caches.open(name)).put(url, response);
    return true;
  } catch {
    return false;
  }
}
