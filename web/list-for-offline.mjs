// Runs at the end of a Trunk build: writes into the page what it says when none of its modules arrives, tells the service
// worker which files there are and what is in them, and gives the set a version, which the page says of itself too. It may
// run again over the same folder.
import { createHash } from "node:crypto";
import { readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";

const LIST = /^const OFFLINE = .*;$/m;
const VERSION = /(?<=<meta name="version" content=")\w+(?=">)/;
const NOT_STARTED = /(?<=<div id="not-started-words">)[\s\S]*?(?=<\/div>)/;
/** The page is asked for as "./", and its text, which says the version, has no hash of its own. */
const PAGE = "index.html";
/** What only browsers without WebGPU download. */
const FALLBACK = /^wasm\/rosto-studio-webgl/;

const dist = process.env.TRUNK_STAGING_DIR ?? "dist";

await fill(PAGE, NOT_STARTED, await wordsOfFailure());

const names = (await readdir(dist, { recursive: true, withFileTypes: true }))
  .filter((entry) => entry.isFile())
  .map((entry) => path.relative(dist, path.join(entry.parentPath, entry.name)).replaceAll(path.sep, "/"))
  .filter((name) => !name.startsWith(".") && !name.endsWith(".d.ts") && name !== PAGE && name !== "service-worker.js")
  .sort();
const files = await Promise.all(names.map(async (name) => [name, `sha256-${sha256(await read(name)).digest("base64")}`]));

const page = String(await read(PAGE)).replace(VERSION, "unbuilt");
const version = sha256(JSON.stringify(files)).update(page).digest("hex").slice(0, 16);
const chosen = (isFallback) => Object.fromEntries(files.filter(([name]) => FALLBACK.test(name) === isFallback));
const list = { version, files: chosen(false), fallback: chosen(true) };

await fill(PAGE, VERSION, version);
await fill("service-worker.js", LIST, `const OFFLINE = ${JSON.stringify(list)};`);

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

/** @param {string | Uint8Array} content */
function sha256(content) {
  return createHash("sha256").update(content);
}

/**
 * @param {string} name
 * @param {RegExp} place
 * @param {string} content
 */
async function fill(name, place, content) {
  const text = String(await read(name));
  if (!place.test(text)) throw new Error(`${path.join(dist, name)} has no place for ${content}`);
  await writeFile(path.join(dist, name), text.replace(place, () => content));
}
