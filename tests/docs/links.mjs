import { existsSync } from "node:fs";
import { readdir, readFile } from "node:fs/promises";
import { join, relative } from "node:path";
import { parse } from "node-html-parser";
import { addressesIn, headingsIn, isElsewhere, reader, resolved } from "../../docs/site/markdown.mjs";

const NOT_OURS = /(^|\/)(node_modules|target|dist|\.git)(\/|$)/;
const markdown = reader();

/** All Markdown of a folder, from there. @param {string} root */
export async function textsIn(root) {
  const entries = await readdir(root, { recursive: true });
  return entries.filter((path) => path.endsWith(".md") && !NOT_OURS.test(path)).sort();
}

/**
 * The links and pictures of Markdown files that lead nowhere: to no file of the repository, or to no heading.
 *
 * @param {string} root
 * @param {string[]} texts from there
 */
export async function deadInTexts(root, texts) {
  /** @type {string[]} */
  const dead = [];
  for (const text of texts) {
    for (const address of addressesIn(markdown, await readFile(join(root, text), "utf8"))) {
      if (!(await leads(root, text, address))) dead.push(`${text}: ${address}`);
    }
  }
  return dead;
}

/**
 * The same of a site's pages; what would be loaded from elsewhere counts as well.
 *
 * @param {string} folder
 */
export async function deadInSite(folder) {
  /** @type {Map<string, import("node-html-parser").HTMLElement>} */
  const pages = new Map();
  for (const name of await readdir(folder, { recursive: true })) {
    if (name.endsWith(".html")) pages.set(name, parse(await readFile(join(folder, name), "utf8")));
  }
  const dead = [...pages].map(([name, page]) => {
    const addressed = page.querySelectorAll("[href], [src]").map((element) => ({
      address: element.getAttribute("href") ?? element.getAttribute("src") ?? "",
      isLink: element.rawTagName === "a",
    }));
    const isFine = (/** @type {{ address: string, isLink: boolean }} */ { address, isLink }) =>
      isElsewhere(address) ? isLink && isAddress(address) : isThere(folder, pages, name, address);
    return addressed.filter((each) => !isFine(each)).map(({ address }) => `${name}: ${address}`);
  });
  return dead.flat();
}

/** @param {string} root @param {string} text @param {string} address */
async function leads(root, text, address) {
  if (isElsewhere(address)) return isAddress(address);
  const { path, heading } = resolved(text, address);
  const place = join(root, path);
  if (relative(root, place).startsWith("..") || !existsSync(place)) return false;
  if (!heading) return true;
  return path.endsWith(".md") && headingsIn(markdown, await readFile(place, "utf8")).includes(heading);
}

/**
 * @param {string} folder
 * @param {Map<string, import("node-html-parser").HTMLElement>} pages
 * @param {string} name
 * @param {string} address
 */
function isThere(folder, pages, name, address) {
  const { path, heading } = resolved(name, address);
  if (!existsSync(join(folder, path))) return false;
  const id = decodeURIComponent(heading);
  return !heading || (pages.get(path)?.querySelectorAll("[id]").some((element) => element.id === id) ?? false);
}

/** @param {string} address */
function isAddress(address) {
  return /^(https|mailto):/.test(address) && URL.canParse(address);
}
