/** Base URL of the files loaded at run time. */
let base: URL | undefined;

/**
 * Sets the folder of the package's files; by default, the one of this script. Call it before any other function; files
 * already loaded stay in use.
 *
 * @param url of the folder, with or without a trailing slash
 * @param from address to which it is relative
 */
export function init(url: string | URL, from = location.href) {
  if (!URL.canParse(url, from)) throw { code: "bad-choice", message: `base is "${url}"; use an address`, hint: "" };
  const folder = new URL(url, from);
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
