// Runs at the end of a Trunk build: writes into the page what it says when none of its modules arrives, lists all files
// with their SHA-256 for whoever checks them (the page, the service worker, anybody else), and gives the set a version,
// which the page says of itself too. The hosts' header files go beside them. It may run again over the same folder.
import { createHash } from "node:crypto";
import { readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";
import { hostFiles } from "./headers.mjs";

const OFFLINE = /^const OFFLINE = .*;$/m;
const VERSION = /(?<=<meta name="version" content=")\w+(?=">)/;
const LIST_HASH = /(?<=<meta name="integrity" content=")[^"]+(?=">)/;
const NOT_STARTED = /(?<=<div id="not-started-words">)[\s\S]*?(?=<\/div>)/;
/** The page is asked for as "./", and its text, which says the version and the list's hash, has no hash in the list. */
const PAGE = "index.html";
const LIST = "integrity.json";
/** What only browsers without WebGPU download. */
const FALLBACK = /^wasm\/rosto-studio-webgl/;

const dist = process.env.TRUNK_STAGING_DIR ?? "dist";

await fill(PAGE, NOT_STARTED, await wordsOfFailure());
const forHosts = hostFiles(String(await read(PAGE)));

const unlisted = new Set([PAGE, LIST, "service-worker.js", ...Object.keys(forHosts)]);
const names = (await readdir(dist, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/"))
  .filter((name) => !name.startsWith(".") && !name.endsWith(".d.ts") && !unlisted.has(name))
  .sort();
const files = await Promise.all(names.map(async (name) => [name, integrity(await read(name))]));

const list = `${JSON.stringify({ files: Object.fromEntries(files) }, undefined, 1)}\n`;
await write(LIST, list);
await fill(PAGE, LIST_HASH, integrity(list));

// The page says the hash of the list, so that its own text stands for all there is.
const page = String(await read(PAGE)).replace(VERSION, "unbuilt");
const version = sha256(page).digest("hex").slice(0, 16);
const stored = [...files, [LIST, integrity(list)]];
const chosen = (isFallback) => Object.fromEntries(stored.filter(([name]) => FALLBACK.test(name) === isFallback));

await fill(PAGE, VERSION, version);
await fill("service-worker.js", OFFLINE, `const OFFLINE = ${JSON.stringify({ version, files: chosen(false), fallback: chosen(true) })};`);
for (const [name, text] of Object.entries(forHosts)) await write(name, text);

/** What the page says in every language when it does not start. */
async function wordsOfFailure() {
  const languages = JSON.parse(String(await read("words/languages.json")));
  const words = languages.map(async ({ id, tag }) => ({ tag, words: JSON.parse(String(await read(`words/${id}.json`))) }));
  const all = await Promise.all(words);
  const texts = all.map(({ tag, words }) => [
    `<p class="notice-title" lang="${tag}">${words["not-started"]}</p>`,
    `<p lang="${tag}">${words["not-started.help"]}</p>`,
  ]);
  const again = all.map(({ tag, words }) => `<span lang="${tag}">${words["not-started.again"]}</span>`);
  return [...texts.flat(), `<button class="button small" type="button" id="start-again">${again.join(" · ")}</button>`].join("");
}

/** @param {string} name */
function read(name) {
  return readFile(path.join(dist, name));
}

/** @param {string} name @param {string} text */
function write(name, text) {
  return writeFile(path.join(dist, name), text);
}

/** @param {string | Uint8Array} content */
function sha256(content) {
  return createHash("sha256").update(content);
}

/** As the attribute `integrity` has it. @param {string | Uint8Array} content */
function integrity(content) {
  return `sha256-${sha256(content).digest("base64")}`;
}

/**
 * @param {string} name
 * @param {RegExp} place
 * @param {string} content
 */
async function fill(name, place, content) {
  const text = String(await read(name));
  if (!place.test(text)) throw new Error(`${path.join(dist, name)} has no place for ${content}`);
  await write(name, text.replace(place, () => content));
}
