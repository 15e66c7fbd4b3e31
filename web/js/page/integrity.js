/**
 * List of all files with their SHA-256 hashes, written by the build. Modules and networks are verified against it
 * before use. The page's HTML contains the hash of the list.
 *
 * @typedef {{ files: Record<string, string> }} List
 * @typedef {{ name: string, defaultUrl: URL }} Place
 * @typedef {{ querySelector: (selector: string) => { getAttribute: (name: string) => string | null } | null }} Page
 */
import { fileUrl } from "../files.js";

const LIST = "integrity.json";

/** @type {Promise<List | undefined> | undefined} */
let pendingList;

/** @type {string | undefined} */
let hashOverride;

/** Sets the list's hash in a worker, which has no document: see {@link listHash}. @param {string} hash */
export function setListHash(hash) {
  hashOverride = hash;
}

/** Hash of the list; empty if the page contains none. */
export function listHash() {
  const { document } = /** @type {{ document?: Page }} */ (globalThis);
  return hashOverride ?? document?.querySelector("meta[name='integrity']")?.getAttribute("content") ?? "";
}

/**
 * Fetches a file and verifies its hash. Without a list, the file is not verified.
 *
 * @param {string} name path relative to the page's folder
 * @param {URL} defaultUrl see `fileUrl`
 * @param {(answer: Response) => void} [onResponse] called when a response starts; may clone and read it
 */
export function verifiedFile(name, defaultUrl, onResponse) {
  return fetchVerified({ name, defaultUrl }, (answer) => answer.arrayBuffer(), onResponse);
}

/**
 * Compiles a wasm module while it arrives, and returns it if its hash is correct.
 *
 * @param {string} name path relative to the page's folder
 * @param {URL} defaultUrl
 * @param {(answer: Response) => void} [onResponse]
 */
export function verifiedModule(name, defaultUrl, onResponse) {
  return fetchVerified({ name, defaultUrl }, compiled, onResponse);
}

/**
 * Fetches a file; on a hash mismatch, fetches it once more past the HTTP cache, which may hold an older version.
 *
 * @template T
 * @param {Place} place
 * @param {(answer: Response) => Promise<T>} process
 * @param {(answer: Response) => void} [onResponse]
 */
async function fetchVerified(place, process, onResponse) {
  // In parallel.
  const [expected, first] = await Promise.all([expectedHash(place.name), fetchFile(place, "default", onResponse)]);
  const result = (await ifMatching(expected, first, process)) ?? (await ifMatching(expected, await fetchFile(place, "reload", onResponse), process));
  if (result) return result.of;
  throw mismatchError(`${place.name} is not the file that was built`);
}

/**
 * Processes a response; undefined if its hash differs.
 *
 * @template T
 * @param {string | undefined} expected
 * @param {Response} answer
 * @param {(answer: Response) => Promise<T>} process
 */
async function ifMatching(expected, answer, process) {
  if (!expected) return { of: await process(answer) };
  const copy = answer.clone();
  const processed = process(answer);
  // An error matters only if the hash is correct.
  processed.catch(() => {});
  return (await sha256(await copy.arrayBuffer())) === expected ? { of: await processed } : undefined;
}

/** @param {Response} answer */
async function compiled(answer) {
  // compileStreaming requires the MIME type, which some servers do not send.
  const isTyped = answer.headers.get("content-type") === "application/wasm";
  return isTyped ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** @param {string} name */
async function expectedHash(name) {
  pendingList ??= loadList().catch((error) => {
    pendingList = undefined;
    throw error;
  });
  const files = (await pendingList)?.files;
  if (files && !files[name]) throw mismatchError(`${name} is not in the list`);
  return files?.[name];
}

/** @returns {Promise<List | undefined>} */
async function loadList() {
  const hash = listHash();
  if (!hash.startsWith("sha256-")) return undefined;
  const place = { name: LIST, defaultUrl: new URL("../../integrity.json", import.meta.url) };
  const read = async (/** @type {RequestCache} */ cache) => ifMatching(hash, await fetchFile(place, cache), (answer) => answer.json());
  const result = (await read("default")) ?? (await read("reload"));
  if (result) return result.of;
  throw mismatchError(`${LIST} does not match the hash in the page`);
}

/**
 * @param {Place} place
 * @param {RequestCache} cache
 * @param {(answer: Response) => void} [onResponse]
 */
async function fetchFile({ name, defaultUrl }, cache, onResponse) {
  const answer = await fetch(fileUrl(name, defaultUrl), { cache });
  if (!answer.ok) throw new Error(`${name}: HTTP status ${answer.status}`);
  onResponse?.(answer);
  return answer;
}

/** @param {ArrayBuffer} bytes */
async function sha256(bytes) {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return `sha256-${btoa(String.fromCharCode(...hash))}`;
}

/** @param {string} message */
function mismatchError(message) {
  return { code: "not-as-built", message, hint: "" };
}
