/**
 * The documentation as a static site, made of the same texts that the repository shows: node docs/site/build.mjs FOLDER. Without
 * scripts, and nothing of it comes from elsewhere. ROSTO_CLI is the command line's program, which says what it can do.
 */

import { copyFile, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { commandLine } from "./command-line.mjs";
import { html, isElsewhere, reader, resolved, titleOf } from "./markdown.mjs";
import { measured } from "./measurements.mjs";
import { PAGES } from "./pages.mjs";
import { pythonReference } from "./python.mjs";
import { whole } from "./template.mjs";

/** @typedef {import("./pages.mjs").Page} Page */

const ROOT = join(import.meta.dirname, "../..");
const OWN_FILES = { "docs/site/site.css": "site.css", "web/icons/rosto.svg": "icon.svg" };

const markdown = reader();
const nameOf = new Map(PAGES.map(({ source, name }) => [source, name]));
/** From the repository's root, with where they lie on the site. @type {Map<string, string>} */
const files = new Map(Object.entries(OWN_FILES));

const folder = process.argv[2];
if (!folder) throw new Error("node docs/site/build.mjs FOLDER: the folder is missing");
await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
for (const page of PAGES) await writeFile(join(folder, `${page.name}.html`), await made(page));
for (const [from, to] of files) await copied(from, join(folder, to));
console.log(`${PAGES.length} pages and ${files.size} files in ${folder}`);

/** @param {Page} page */
async function made(page) {
  const text = await textOf(page);
  const article = html(markdown, text, (address, kind) => placed(page, address, kind));
  return whole(page, titleOf(text), article);
}

/** @param {Page} page */
async function textOf({ source, data, reference }) {
  const text = source && (await readFile(join(ROOT, source), "utf8"));
  if (text && data) return text + measured(JSON.parse(await readFile(join(ROOT, data), "utf8")));
  if (text) return text;
  return reference === "python" ? pythonReference(ROOT) : commandLine(program());
}

/**
 * @param {Page} page
 * @param {string} address
 * @param {"link" | "picture"} kind
 */
function placed({ source = "docs/", name }, address, kind) {
  if (isElsewhere(address)) return kind === "link" ? address : undefined;
  const { path, heading } = resolved(source, address);
  const after = heading && `#${heading}`;
  if (kind === "picture" || /\.(png|jpe?g|svg)$/.test(path)) return pictured(path);
  if (path === source) return after || `${name}.html`;
  const page = nameOf.get(path);
  return page && `${page}.html${after}`;
}

/** @param {string} path */
function pictured(path) {
  const place = path.replace(/^docs\//, "").replace(/^.*\/(?=images\/)/, "");
  files.set(path, place);
  return place;
}

/** @param {string} from @param {string} to */
async function copied(from, to) {
  await mkdir(dirname(to), { recursive: true });
  await copyFile(join(ROOT, from), to);
}

function program() {
  const path = process.env["ROSTO_CLI"];
  if (!path) throw new Error("ROSTO_CLI must name the program rosto: cargo xtask site builds it and says where it is");
  return path;
}
