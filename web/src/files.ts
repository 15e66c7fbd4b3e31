/** Base URL of the files loaded at run time. */
let base: URL | undefined;

/**
 * Sets the folder of the package's files; by default, the one of this script. Call it before any other function; files
 * already loaded stay in use.
 *
 * @param url of the folder, with or without a trailing slash
 */
export function init(url: string | URL) {
  const folder = new URL(url, location.href);
  if (!folder.pathname.endsWith("/")) folder.pathname += "/";
  base = folder;
}

/**
 * URL of a file of the package.
 *
 * @param fallback a literal `new URL("./name", import.meta.url)` at the call, which bundlers recognise
 */
export function fileUrl(fallback: URL) {
  return base ? new URL(fallback.pathname.split("/").at(-1) ?? "", base) : fallback;
}

/** Fetches a file; throws unless the server has it. */
export async function fetchFile(url: URL | string, options?: RequestInit) {
  const response = await fetch(url, options);
  if (!response.ok) throw new Error(`${url}: HTTP status ${response.status}`);
  return response;
}
