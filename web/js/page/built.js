/**
 * What a module or a network is held against before it is used: the list of all files with their SHA-256, which the build
 * writes. The page's text says the hash of the list itself.
 *
 * @typedef {{ files: Record<string, string> }} List
 * @typedef {{ name: string, usual: URL }} Place
 * @typedef {{ querySelector: (selector: string) => { getAttribute: (name: string) => string | null } | null }} Page
 */
import { placeOf } from "../files.js";

const LIST = "integrity.json";

/** @type {Promise<List | undefined> | undefined} */
let listed;

/** @type {string | undefined} */
let vouched;

/** Says in a worker, which has no page to read, what the page says: see {@link listHash}. @param {string} hash */
export function vouchFor(hash) {
  vouched = hash;
}

/** The hash of the list as the page's text says it; of a page that vouches for nothing, an empty text. */
export function listHash() {
  const { document } = /** @type {{ document?: Page }} */ (globalThis);
  return vouched ?? document?.querySelector("meta[name='integrity']")?.getAttribute("content") ?? "";
}

/**
 * A file of the page, whole and as it was built. On a page that vouches for no list it comes as it is.
 *
 * @param {string} name from the page's folder on
 * @param {URL} usual where it lies beside these modules, see `placeOf`
 * @param {(answer: Response) => void} [arriving] is told of each answer as it begins; it may read a copy
 */
export function builtFile(name, usual, arriving) {
  return asBuilt({ name, usual }, (answer) => answer.arrayBuffer(), arriving);
}

/**
 * A module of the page. It is compiled as it comes, and handed out once it is known to be the one that was built.
 *
 * @param {string} name from the page's folder on
 * @param {URL} usual
 * @param {(answer: Response) => void} [arriving]
 */
export function builtModule(name, usual, arriving) {
  return asBuilt({ name, usual }, compiled, arriving);
}

/**
 * What is not as it was built is asked for once more, past the browser's memory, which may hold an older one.
 *
 * @template T
 * @param {Place} place
 * @param {(answer: Response) => Promise<T>} use
 * @param {(answer: Response) => void} [arriving]
 */
async function asBuilt(place, use, arriving) {
  // Both are on their way at once.
  const [expected, first] = await Promise.all([hashOf(place.name), answerFor(place, "default", arriving)]);
  const made = (await ifBuilt(expected, first, use)) ?? (await ifBuilt(expected, await answerFor(place, "reload", arriving), use));
  if (made) return made.of;
  throw damaged(`${place.name} is not the file that was built`);
}

/**
 * What is made of an answer, or nothing if its bytes have another hash.
 *
 * @template T
 * @param {string | undefined} expected
 * @param {Response} answer
 * @param {(answer: Response) => Promise<T>} use
 */
async function ifBuilt(expected, answer, use) {
  if (!expected) return { of: await use(answer) };
  const copy = answer.clone();
  const using = use(answer);
  // Whether it is of use matters only where it is the right one.
  using.catch(() => {});
  return (await sha256(await copy.arrayBuffer())) === expected ? { of: await using } : undefined;
}

/** @param {Response} answer */
async function compiled(answer) {
  // Not every server knows the type, which compiling while it comes asks for.
  const isTyped = answer.headers.get("content-type") === "application/wasm";
  return isTyped ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer());
}

/** @param {string} name */
async function hashOf(name) {
  listed ??= list().catch((error) => {
    listed = undefined;
    throw error;
  });
  const files = (await listed)?.files;
  if (files && !files[name]) throw damaged(`${name} is not in the list`);
  return files?.[name];
}

/** @returns {Promise<List | undefined>} */
async function list() {
  const hash = listHash();
  if (!hash.startsWith("sha256-")) return undefined;
  const place = { name: LIST, usual: new URL("../../integrity.json", import.meta.url) };
  const read = async (/** @type {RequestCache} */ cache) => ifBuilt(hash, await answerFor(place, cache), (answer) => answer.json());
  const made = (await read("default")) ?? (await read("reload"));
  if (made) return made.of;
  throw damaged(`${LIST} is not the list that the page vouches for`);
}

/**
 * @param {Place} place
 * @param {RequestCache} cache
 * @param {(answer: Response) => void} [arriving]
 */
async function answerFor({ name, usual }, cache, arriving) {
  const answer = await fetch(placeOf(name, usual), { cache });
  if (!answer.ok) throw new Error(`${name}: ${answer.status}`);
  arriving?.(answer);
  return answer;
}

/** @param {ArrayBuffer} bytes */
async function sha256(bytes) {
  const hash = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return `sha256-${btoa(String.fromCharCode(...hash))}`;
}

/** @param {string} message */
function damaged(message) {
  return { code: "not-as-built", message, hint: "" };
}
