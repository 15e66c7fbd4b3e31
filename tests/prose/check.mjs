/** Finds phrases that read like a translation, by the rules in this folder. */

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { fromYAMLFilePath } from "prh";

export const ROOT = join(import.meta.dirname, "../..");

const PROSE = /(?:\.(?:md|rs|wgsl|js|mjs|ts|py|pyi|css|html|toml|ya?ml|jsonc|cff|sh|webmanifest)|(?:^|\/)package\.json|^web\/words\/\w+\.json)$/;
/** The rules quote the phrases that they find. */
const ELSEWHERE = /^tests\/prose\/|(?:^|\/)Cargo\.lock$/;
/** Folders without sources, as far as no `.gitignore` is read. */
const BUILT = new Set([".git", "node_modules", "target", "dist"]);

const rules = (/** @type {string} */ name) => fromYAMLFilePath(join(import.meta.dirname, `${name}.yml`));
const english = [rules("rules")];
const words = new Map([
  ["web/words/en.json", [...english, rules("words")]],
  ["web/words/pt.json", [rules("portuguese")]],
]);

/**
 * A hit of a rule.
 * @typedef {{ file: string, line: number, found: string, suggestion: string, rule: string }} Hit
 */

/**
 * The hits in a text, in its order.
 * @param {string} file its path from the root, which chooses the rules
 * @param {string} text
 * @returns {Hit[]}
 */
export function hitsIn(file, text) {
  const diffs = (words.get(file) ?? english).flatMap((engine) => engine.makeChangeSet(file, text).diffs);
  const hits = diffs.map(({ index, matches, newText, expected }) => ({
    file,
    line: text.slice(0, index).split("\n").length,
    found: (matches[0] ?? "").replaceAll(/[\s/*#!]+/g, " "),
    suggestion: newText ?? "",
    rule: expected ?? "",
  }));
  return hits.toSorted((one, other) => one.line - other.line);
}

/** The hit as one line for a terminal. @param {Hit} hit */
export function described({ file, line, found, suggestion }) {
  return `${file}:${line}: "${found}" → ${suggestion}`;
}

/** The files with prose, as paths from the root: all that git does not ignore, or all in an archive without git. */
export function filesWithProse() {
  const listed = fromGit();
  const files = listed.length > 0 ? listed : walked("");
  return files.filter((file) => PROSE.test(file) && !ELSEWHERE.test(file) && existsSync(join(ROOT, file))).toSorted();
}

function fromGit() {
  const listing = ["ls-files", "-z", "--cached", "--others", "--exclude-standard"];
  try {
    return execFileSync("git", listing, { cwd: ROOT, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }).split("\0");
  } catch {
    return [];
  }
}

/** @param {string} folder a path from the root that ends with a slash, or "" @returns {string[]} */
function walked(folder) {
  return readdirSync(join(ROOT, folder), { withFileTypes: true }).flatMap((entry) => {
    if (entry.isDirectory()) return BUILT.has(entry.name) ? [] : walked(`${folder}${entry.name}/`);
    return entry.isFile() ? [`${folder}${entry.name}`] : [];
  });
}
