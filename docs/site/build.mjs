/**
 * Builds the documentation as a static site from the repository's Markdown: node docs/site/build.mjs FOLDER. The site has no
 * scripts and loads nothing from other hosts. ROSTO_CLI is the path of the program `rosto`, whose help becomes a page.
 */

import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { commandLine } from "./command-line.mjs";
import { html, isElsewhere, reader, resolved, titleOf } from "./markdown.mjs";
import { measurementsAsMarkdown } from "./measurements.mjs";
import { PAGES } from "./pages.mjs";
import { pythonReference } from "./python.mjs";
import { document } from "./template.mjs";

/** @typedef {import("./pages.mjs").Page} Page */

const ROOT = join(import.meta.dirname, "../..");
const STATIC_FILES = { "docs/site/site.css": "site.css", "web/icons/rosto.svg": "icon.svg" };

const markdown = reader();
const nameBySource = new Map(PAGES.map(({ source, name }) => [source, name]));
/** Files to copy: path from the repository's root → path on the site. @type {Map<string, string>} */
const files = new Map(Object.entries(STATIC_FILES));

const folder = process.argv[2];
if (!folder) throw new Error("no output folder given: run `node docs/site/build.mjs FOLDER`");
await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
for (const page of PAGES) await writeFile(join(folder, `${page.name}.html`), await rendered(page));
for (const [from, to] of files) await copy(from, join(folder, to));
console.log(`${PAGES.length} pages and ${files.size} files in ${folder}`);

/** @param {Page} page */
async function rendered(page) {
  const text = await textOf(page);
  const article = html(markdown, text, (address, kind) => siteAddress(page, address, kind));
  return document(page, titleOf(text), article);
}

/** @param {Page} page */
async function textOf({ source, data, reference }) {
  const text = source && (await readFile(join(ROOT, source), "utf8"));
  if (text && data) return text + measurementsAsMarkdown(JSON.parse(await readFile(join(ROOT, data), "utf8")));
  if (text) return text;
  return reference === "python" ? pythonReference(ROOT) : commandLine(program());
}

/**
 * Address on the site for an address in a page's text; `undefined` if the site does not have it.
 *
 * @param {Page} page
 * @param {string} address
 * @param {"link" | "picture"} kind
 */
function siteAddress({ source = "docs/", name }, address, kind) {
  if (isElsewhere(address)) return kind === "link" ? address : undefined;
  const { path, heading } = resolved(source, address);
  const fragment = heading && `#${heading}`;
  if (kind === "picture" || /\.(png|jpe?g|svg)$/.test(path)) return addPicture(path);
  if (path === source) return fragment || `${name}.html`;
  const page = nameBySource.get(path);
  return page && `${page}.html${fragment}`;
}

/** Adds a picture to the files to copy. @param {string} path @returns {string} its address on the site */
function addPicture(path) {
  const address = path.replace(/^docs\//, "").replace(/^.*\/(?=images\/)/, "");
  files.set(path, address);
  return address;
}

/** @param {string} from @param {string} to */
async function copy(from, to) {
  await mkdir(dirname(to), { recursive: true });
  await copyFile(join(ROOT, from), to);
}

function program() {
  const path = process.env["ROSTO_CLI"];
  if (!path) throw new Error("ROSTO_CLI is not set: run `cargo xtask site`, which builds the program rosto and sets it");
  return path;
}
