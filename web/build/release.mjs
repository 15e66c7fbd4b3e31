// Names the folder of a build by its content, and writes what lies next to it: index.html, the service worker, and the
// header files of common hosts.
import { createHash } from "node:crypto";
import { readFile, readdir, rename, writeFile } from "node:fs/promises";
import path from "node:path";
import { build } from "esbuild";
import { hostFiles } from "./headers.mjs";
import { SHARED, WEB } from "./scripts.mjs";

/** Name of the folder before its content is known, also in `index.html`. */
export const UNNAMED = "VERSION";

/** Link or script of the page with a hash to be filled in. */
const CHECKED = new RegExp(`((?:src|href)="${UNNAMED}/([^"]+)" integrity=")[^"]*`, "g");
// Also where an earlier release has filled them.
const LOADING = /(?<=<p id="loading"[^>]*>)[\s\S]*?(?=<\/p>)/;
const NOT_STARTED = /(?<=<div id="not-started-words">)[\s\S]*?(?=<\/div>)/;

/** @param {string} dist folder with `index.html` and the folder {@link UNNAMED} */
export async function release(dist) {
  const files = await hashes(path.join(dist, UNNAMED));
  const version = sha256(JSON.stringify(files)).digest("hex").slice(0, 16);
  await rename(path.join(dist, UNNAMED), path.join(dist, version));
  const page = path.join(dist, "index.html");
  const words = await allWords();
  const html = fill(fill(String(await readFile(page)), LOADING, inAll(words, "loading")), NOT_STARTED, failureHtml(words));
  const checked = html.replace(CHECKED, (_, start, name) => start + files[name]).replaceAll(`${UNNAMED}/`, `${version}/`);
  await writeFile(page, checked);
  await buildServiceWorker(dist, version, files);
  for (const [name, text] of Object.entries(hostFiles(html, version))) await writeFile(path.join(dist, name), text);
}

/**
 * The service worker contains the version and the hashes of its files.
 *
 * @param {string} dist
 * @param {string} version
 * @param {Record<string, string>} files
 */
async function buildServiceWorker(dist, version, files) {
  await build({
    ...SHARED,
    format: "iife",
    entryPoints: ["src/service-worker.ts"],
    outfile: path.resolve(dist, "service-worker.js"),
    define: { BUILD: JSON.stringify({ version, files }) },
  });
}

/** SHA-256 of each file, in the format of the `integrity` attribute. @param {string} folder */
async function hashes(folder) {
  const names = (await readdir(folder)).sort();
  const hash = async (name) => `sha256-${sha256(await readFile(path.join(folder, name))).digest("base64")}`;
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, await hash(name)])));
}

/** @param {string | Uint8Array} content */
function sha256(content) {
  return createHash("sha256").update(content);
}

/** Words of each language. @returns {Promise<{ tag: string, words: Record<string, string> }[]>} */
async function allWords() {
  const read = async (name) => JSON.parse(String(await readFile(path.join(WEB, "words", `${name}.json`))));
  return Promise.all((await read("languages")).map(async ({ id, tag }) => ({ tag, words: await read(id) })));
}

/** A text in all languages. @param {Awaited<ReturnType<typeof allWords>>} all @param {string} key */
function inAll(all, key) {
  return all.map(({ tag, words }) => `<span lang="${tag}">${words[key]}</span>`).join(" · ");
}

/** The message shown when the page fails to start. @param {Awaited<ReturnType<typeof allWords>>} all */
function failureHtml(all) {
  const texts = all.map(({ tag, words }) => [
    `<p class="notice-title" lang="${tag}">${words["not-started"]}</p>`,
    `<p lang="${tag}">${words["not-started.help"]}</p>`,
  ]);
  return [...texts.flat(), `<a class="button small" href="./" id="start-again">${inAll(all, "not-started.again")}</a>`].join("");
}

/** @param {string} text @param {RegExp} placeholder @param {string} content */
function fill(text, placeholder, content) {
  if (!placeholder.test(text)) throw new Error(`index.html has no placeholder ${placeholder}`);
  return text.replace(placeholder, () => content);
}
