/**
 * Keeps the page usable without a network after the first visit: its files are stored when it is installed, and a new
 * version is never hidden by an old copy. The module that draws through WebGL2 is stored for the browsers that use it.
 *
 * Versions are never mixed. The store holds files of one version, checked by their hashes. The page is asked of the
 * network first, and says in its text which version it is; the page that was given out last decides for its files:
 * - the stored version: the files are the stored ones, byte for byte, so they come from the store at once;
 * - another version: they come from the network alone, and if they fail, the page says that it did not load;
 * - no answer in time, or an error: the page comes from the store, and so do they.
 */
const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/**
 * Written by list-for-offline.mjs when the page is built: files with their hashes as `integrity` has them.
 *
 * @type {{ version: string, files: Record<string, string>, fallback: Record<string, string> }}
 */
const OFFLINE = { version: "unbuilt", files: {}, fallback: {} };

const CACHE = `rosto-${OFFLINE.version}`;

/** The page's own address in the store. */
const PAGE = "./";

/** A server silent for this long has not answered. */
const PATIENCE_MS = 3000;

/** Kept beside the files while another version is out, since the browser ends this script whenever it likes. */
const OTHER_IS_OUT = "./another-version-is-out";

/** @type {boolean | undefined} not known before it was looked up */
let otherIsOut;

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
  if (request.method !== "GET" || !request.url.startsWith(worker.registration.scope)) return;
  event.respondWith(isPage(request) ? givePage(request) : giveFile(request));
});

async function store() {
  const cache = await caches.open(CACHE);
  const page = await fetch(PAGE, { cache: "no-cache" });
  if ((await versionOf(page)) !== OFFLINE.version) throw new Error("the page is of another version than this script");
  await cache.put(PAGE, page);
  await cache.addAll(Object.entries(OFFLINE.files).map(asBuilt));
  await worker.skipWaiting();
}

async function storeFallback() {
  const cache = await caches.open(CACHE);
  const files = Object.entries(OFFLINE.fallback);
  const stored = await Promise.all(files.map(([file]) => cache.match(file)));
  if (!stored.every(Boolean)) await cache.addAll(files.map(asBuilt));
}

/**
 * A request that fails where the answer is not the file that was built: from the browser's memory of an earlier version,
 * from a server in the middle of a change, or from someone else in between.
 *
 * @param {[string, string]} entry
 */
function asBuilt([file, integrity]) {
  return new Request(file, { cache: "no-cache", integrity });
}

async function dropOldCaches() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith("rosto-") && name !== CACHE).map((name) => caches.delete(name)));
}

/** @param {Request} request */
function isPage(request) {
  const { pathname } = new URL(request.url);
  const scope = new URL(worker.registration.scope).pathname;
  return request.mode === "navigate" && (pathname === scope || pathname === `${scope}index.html`);
}

/** @param {Request} request */
async function givePage(request) {
  const stored = await storedAs(PAGE);
  const fresh = stored ? await inTime(request) : await fetch(request);
  await letOut(fresh !== undefined && (await versionOf(fresh)) !== OFFLINE.version);
  return fresh ?? /** @type {Response} */ (stored);
}

/**
 * What the network answers, if it comes whole, in time and without an error.
 *
 * @param {Request} request
 */
async function inTime(request) {
  const late = new AbortController();
  const limit = setTimeout(() => late.abort(), PATIENCE_MS);
  try {
    const response = await fetch(request, { signal: late.signal });
    await response.clone().text();
    // A redirection is the browser's to follow.
    return response.ok || response.type === "opaqueredirect" ? response : undefined;
  } catch {
    return undefined;
  } finally {
    clearTimeout(limit);
  }
}

/** @param {Response} page */
async function versionOf(page) {
  return /<meta name="version" content="(\w+)">/.exec(await page.clone().text())?.[1];
}

/** @param {Request} request */
async function giveFile(request) {
  const stored = (await isOtherOut()) ? undefined : await storedAs(request);
  return stored ?? fetch(request);
}

/** @param {boolean} isOther whether the page that is given out now is of another version than the store */
async function letOut(isOther) {
  otherIsOut = isOther;
  try {
    const cache = await caches.open(CACHE);
    if (isOther) await cache.put(OTHER_IS_OUT, new Response());
    else await cache.delete(OTHER_IS_OUT);
  } catch {
    // On a full disk it holds until the browser ends this script.
  }
}

async function isOtherOut() {
  otherIsOut ??= (await storedAs(OTHER_IS_OUT)) !== undefined;
  return otherIsOut;
}

/**
 * A store that cannot be read is an empty one.
 *
 * @param {Request | string} request
 */
async function storedAs(request) {
  try {
    const cache = await caches.open(CACHE);
    return await cache.match(request, { ignoreSearch: true, ignoreVary: true });
  } catch {
    return undefined;
  }
}
