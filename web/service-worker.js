/**
 * Keeps the page usable without a network after the first visit: its files are stored when this script is installed, and a
 * new version is not hidden by an old copy. The module that draws through WebGL2 is stored for the browsers that use it.
 *
 * Each open page gets the files of the version that it was opened as. There is one store per version, checked by hashes, and
 * a note of each page's version, and of each of its workers':
 * - The page itself is asked of the network first. When no answer comes in time, or an error, it comes from the store.
 * - Its files come from the store of its version. What is not stored comes from the network, and has to have the hash that
 *   the page's list of files says; if it has another, loading it fails.
 *
 * After a deploy, the new version's script stores its files, then waits until all pages are closed. Until then the old script
 * serves the pages of both versions.
 */
const worker = /** @type {ServiceWorkerGlobalScope} */ (/** @type {unknown} */ (self));

/**
 * What a page says of itself: its version, and the hash of its list of files.
 *
 * @typedef {{ version: string, list: string }} Build
 */

/**
 * Written by list-for-offline.mjs when the page is built: files with their hashes as `integrity` has them.
 *
 * @type {{ version: string, files: Record<string, string>, fallback: Record<string, string> }}
 */
const OFFLINE = { version: "unbuilt", files: {}, fallback: {} };

/** The page's own address in the store. */
const PAGE = "./";

const LIST = "integrity.json";

/** A server silent for this long has not answered. */
const PATIENCE_MS = 3000;

/** The store of notes. They are kept, since the browser ends this script whenever it likes. */
const NOTES = "rosto-notes";

/** The latest notes outlast their pages: a page that is only being opened is not among the open ones yet. */
const SPARED_NOTES = 20;

/** The page holds these against its list by itself, while they arrive: see integrity.js. */
const CHECKED_BY_PAGE = /\.(wasm|onnx)$/;

/** The notes that were written or read since this script was started. @type {Map<string, Build>} */
const known = new Map();

worker.addEventListener("install", (event) => {
  event.waitUntil(store());
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(tidy());
});

worker.addEventListener("message", (event) => {
  const { source, data } = event;
  if (data.type === "opened" && source instanceof Client) event.waitUntil(serve(source, data.build));
  if (data.type === "keep-fallback") event.waitUntil(storeFallback());
});

worker.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(worker.registration.scope)) return;
  event.respondWith(isPage(request) ? givePage(event) : giveFile(event));
});

async function store() {
  const cache = await caches.open(storeOf(OFFLINE.version));
  const page = await fetch(PAGE, { cache: "no-cache" });
  if ((await buildOf(page))?.version !== OFFLINE.version) throw new Error("the page is of another version than this script");
  await cache.addAll(Object.entries(OFFLINE.files).map(asBuilt));
  // A browser that needed the other module before needs it again.
  const stored = await Promise.all(Object.keys(OFFLINE.fallback).map((file) => caches.match(file)));
  if (stored.some(Boolean)) await storeFallback();
  // Last: a store that holds its page is complete.
  await cache.put(PAGE, page);
}

async function storeFallback() {
  const cache = await caches.open(storeOf(OFFLINE.version));
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

/** Drops the stores of versions that no page needs, and the notes of pages that are closed. */
async function tidy() {
  const open = await worker.clients.matchAll({ type: "all", includeUncontrolled: true });
  const builds = await Promise.all(open.map(({ id }) => noteOf(id)));
  const needed = new Set([NOTES, storeOf(OFFLINE.version), ...builds.map((build) => build && storeOf(build.version))]);
  const names = (await caches.keys()).filter((name) => name.startsWith("rosto-") && !needed.has(name));
  await Promise.all(names.map((name) => caches.delete(name)));
  const cache = await caches.open(NOTES);
  const older = (await cache.keys()).slice(0, -SPARED_NOTES);
  const closed = older.filter(({ url }) => !open.some(({ id }) => url.endsWith(`/${id}`)));
  await Promise.all(closed.map((request) => cache.delete(request)));
}

/**
 * Serves a page from now on that was opened without this script.
 *
 * @param {Client} page
 * @param {Build} build
 */
async function serve({ id }, build) {
  await note(id, build);
  await worker.clients.claim();
}

/** @param {Request} request */
function isPage(request) {
  const { pathname } = new URL(request.url);
  const scope = new URL(worker.registration.scope).pathname;
  return request.mode === "navigate" && (pathname === scope || pathname === `${scope}index.html`);
}

/** @param {FetchEvent} event */
async function givePage({ request, resultingClientId }) {
  const own = await storedIn(storeOf(OFFLINE.version), PAGE);
  const fresh = own ? await inTime(request) : await fetch(request);
  const pages = [fresh, await newestPage(), own].filter((page) => page !== undefined);
  const last = /** @type {Response} */ (pages.pop());
  for (const page of pages) {
    const build = await buildOf(page);
    if (!build || (await note(resultingClientId, build))) return page;
  }
  // On a full disk nothing can be noted, and a page without a note gets the files of this script's version.
  const build = await buildOf(last);
  if (build) await note(resultingClientId, build);
  return last;
}

/** The page of the newest version that is stored whole. */
async function newestPage() {
  const names = (await caches.keys().catch(() => [])).filter((name) => name.startsWith("rosto-") && name !== NOTES);
  for (const name of names.reverse()) {
    const page = await storedIn(name, PAGE);
    if (page) return page;
  }
  return undefined;
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

/**
 * @param {Response} page
 * @returns {Promise<Build | undefined>} nothing if it is not a page of ours
 */
async function buildOf(page) {
  const text = await page.clone().text();
  const said = (/** @type {string} */ name) => new RegExp(`<meta name="${name}" content="([^"]+)">`).exec(text)?.[1];
  const [version, list] = [said("version"), said("integrity")];
  return version && list ? { version, list } : undefined;
}

/** @param {FetchEvent} event */
async function giveFile({ request, clientId, resultingClientId }) {
  const build = await noteOf(clientId);
  // A worker belongs to the page that starts it.
  if (build && resultingClientId) await note(resultingClientId, build);
  const stored = await storedIn(storeOf(build?.version ?? OFFLINE.version), request);
  return stored ?? (build ? fetchOf(build, request) : fetch(request));
}

/**
 * A file of a build that is not in the store.
 *
 * @param {Build} build
 * @param {Request} request
 */
async function fetchOf(build, request) {
  const { origin, pathname } = new URL(request.url);
  const name = `${origin}${pathname}`.slice(worker.registration.scope.length);
  if (name === LIST) return fetch(asBuilt([LIST, build.list]));
  const integrity = CHECKED_BY_PAGE.test(name) ? undefined : (await filesOf(build))[name];
  return integrity ? fetch(asBuilt([request.url, integrity])) : fetch(request);
}

/**
 * The files of a build with their hashes.
 *
 * @param {Build} build
 * @returns {Promise<Record<string, string>>}
 */
async function filesOf({ version, list }) {
  const stored = await storedIn(storeOf(version), LIST);
  const answer = stored ?? (await fetch(asBuilt([LIST, list])));
  if (!stored) await putAway(storeOf(version), LIST, answer.clone());
  return (await answer.json()).files;
}

/** @param {string} version */
function storeOf(version) {
  return `rosto-${version}`;
}

/**
 * Notes which build a page or worker belongs to.
 *
 * @param {string} client
 * @param {Build} build
 * @returns whether that is kept when the browser ends this script
 */
function note(client, build) {
  known.set(client, build);
  return putAway(NOTES, `./builds/${client}`, new Response(JSON.stringify(build)));
}

/**
 * @param {string} client
 * @returns {Promise<Build | undefined>} nothing where none was noted
 */
async function noteOf(client) {
  return known.get(client) ?? (await (await storedIn(NOTES, `./builds/${client}`))?.json());
}

/**
 * A store that cannot be read is an empty one.
 *
 * @param {string} name of the store
 * @param {Request | string} request
 */
async function storedIn(name, request) {
  try {
    const cache = await caches.open(name);
    return await cache.match(request, { ignoreSearch: true, ignoreVary: true });
  } catch {
    return undefined;
  }
}

/**
 * @param {string} name of the store
 * @param {string} address
 * @param {Response} response
 * @returns whether there was room for it
 */
async function putAway(name, address, response) {
  try {
    await (await caches.open(name)).put(address, response);
    return true;
  } catch {
    return false;
  }
}
