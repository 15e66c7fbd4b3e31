/** Base URL of the files loaded at run time. @type {URL | undefined} */
let base;

/**
 * Sets the base URL of the folders `wasm`, `assets` and `words`. By default, they are siblings of this module's folder.
 * Call it before any other function; files already loaded stay in use.
 *
 * @param {string | URL} url of the folder, with or without a trailing slash
 */
export function init(url) {
  const folder = new URL(url, location.href);
  if (!folder.pathname.endsWith("/")) folder.pathname += "/";
  base = folder;
}

/** The base URL set by {@link init}, to be passed to a worker. */
export function filesBase() {
  return base?.href;
}

/**
 * URL of a file.
 *
 * @param {string} name such as "words/en.json"
 * @param {URL} fallback relative to the module; a literal `new URL(…, import.meta.url)` at the call, for bundlers
 */
export function fileUrl(name, fallback) {
  return base ? new URL(name, base) : fallback;
}
