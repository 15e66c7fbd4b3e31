// Trunk's post-build hook; can run repeatedly on the same folder:
// - writes the texts shown when the page fails to start into index.html;
// - writes integrity.json with the SHA-256 of each file, which the page and the service worker verify;
// - writes the version of the build into index.html and the service worker;
// - writes the header files for common hosts.
import { createHash } from "node:crypto";
import { readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";
import { hostFiles } from "./headers.mjs";

const OFFLINE = /^const OFFLINE = .*;$/m;
const VERSION = /(?<=<meta name="version" content=")\w+(?=">)/;
const LIST_HASH = /(?<=<meta name="integrity" content=")[^"]+(?=">)/;
const NOT_STARTED = /(?<=<div id="not-started-words">)[\s\S]*?(?=<\/div>)/;
/** Not in the list, because it contains the hash of the list. */
const PAGE = "index.html";
const LIST = "integrity.json";
/** Downloaded only by browsers without WebGPU. */
const FALLBACK = /^wasm\/rosto-studio-webgl/;

const dist = process.env.TRUNK_STAGING_DIR ?? "dist";

await fill(PAGE, NOT_STARTED, await failureHtml());
const headerFiles = hostFiles(String(await read(PAGE)));

const unlisted = new Set([PAGE, LIST, "service-worker.js", ...Object.keys(headerFiles)]);
const names = (await readdir(dist, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/"))
  .filter((name) => !name.startsWith(".") && !name.endsWith(".d.ts") && !unlisted.has(name))
  .sort();
const files = await Promise.all(names.map(async (name) => [name, integrity(await read(name))]));

const list = `${JSON.stringify({ files: Object.fromEntries(files) }, undefined, 1)}\n`;
await write(LIST, list);
await fill(PAGE, LIST_HASH, integrity(list));

// The page contains the hash of the list, so the hash of the page covers all files.
const page = String(await read(PAGE)).replace(VERSION, "unbuilt");
const version = sha256(page).digest("hex").slice(0, 16);
const cached = [...files, [LIST, integrity(list)]];
const select = (isFallback) => Object.fromEntries(cached.filter(([name]) => FALLBACK.test(name) === isFallback));

await fill(PAGE, VERSION, version);
await fill("service-worker.js", OFFLINE, `const OFFLINE = ${JSON.stringify({ version, files: select(false), fallback: select(true) })};`);
for (const [name, text] of Object.entries(headerFiles)) await write(name, text);

/** The message shown when the page fails to start, in all languages. */
async function failureHtml() {
  const languages = JSON.parse(String(await read("words/languages.json")));
  const words = languages.map(async ({ id, tag }) => ({ tag, words: JSON.parse(String(await read(`words/${id}.json`))) }));
  const all = await Promise.all(words);
  const texts = all.map(({ tag, words }) => [
    `<p class="notice-title" lang="${tag}">${words["not-started"]}</p>`,
    `<p lang="${tag}">${words["not-started.help"]}</p>`,
  ]);
  const retry = all.map(({ tag, words }) => `<span lang="${tag}">${words["not-started.again"]}</span>`);
  return [...texts.flat(), `<button class="button small" type="button" id="start-again">${retry.join(" · ")}</button>`].join("");
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

/** In the format of the `integrity` attribute. @param {string | Uint8Array} content */
function integrity(content) {
  return `sha256-${sha256(content).digest("base64")}`;
}

/**
 * Replaces a placeholder in a file.
 *
 * @param {string} name
 * @param {RegExp} placeholder
 * @param {string} content
 */
async function fill(name, placeholder, content) {
  const text = String(await read(name));
  if (!placeholder.test(text)) throw new Error(`${path.join(dist, name)} has no placeholder ${placeholder}`);
  await write(name, text.replace(placeholder, () => content));
}
