/** The page's words in its languages. */

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";
import { load, pointer } from "./load.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const [en, pt] = await Promise.all(["en", "pt"].map(async (language) => JSON.parse(await readFile(path.join(ROOT, `web/words/${language}.json`), "utf8"))));

const { formatNumber, formatTyped, language, languageFor, setLanguage, t } = await load("words/words.ts");

/** Patterns of error codes in the sources; property names of an error are excluded. */
const SOURCES = [
  { folder: "crates", files: /^(studio|vision)-web\/src\/.*error\.rs$/, codes: /"(?!code"|hint")([a-z]+(?:-[a-z]+)*)"/g },
  { folder: "crates/studio-web/src", files: /\.rs$/, codes: /FacadeError::new\(\s*"([a-z-]+)"/g },
  { folder: "web/src", files: /\.ts$/, codes: /(?:code: |(?:fail|lost)\(|asPageError\(error, )"([a-z-]+)"/g },
];

test("each error code has text in each language", async () => {
  const codes = await allCodes();
  for (const code of ["no-selection", "bad-vertex", "too-many-pixels", "camera-lost", "not-loaded"]) assert.ok(codes.has(code), code);
  const wordless = [...codes].filter((code) => !(`error.${code}` in en && `error.${code}.hint` in en));
  assert.deepEqual(wordless, []);
  assert.deepEqual(Object.keys(pt).sort(), Object.keys(en).sort());
  const alike = Object.keys(en).filter((key) => key.startsWith("error.") && pt[key] === en[key]);
  assert.deepEqual(alike, [], "not translated");
});

test("each hint that promises saved work has a text without the promise", () => {
  const promises = Object.keys(en).filter((key) => /\.hint$/.test(key) && /work is saved|reload the page to continue/i.test(en[key]));
  assert.ok(promises.length > 0);
  for (const key of promises) {
    assert.ok(`${key}.unkept` in en, key);
    assert.doesNotMatch(en[`${key}.unkept`], /saved/, key);
  }
});

test("hints for fingers say neither click nor drop", () => {
  const touched = Object.keys(en).filter((key) => key.endsWith(".touch"));
  assert.match(t("welcome.title"), /Drop a photo/);
  pointer.matches = true;
  assert.match(t("welcome.title"), /Choose or take a photo/);
  pointer.matches = false;
  for (const key of touched) assert.doesNotMatch(en[key], /\b(click|drop a)\b/i, key);
});

test("a browser gets the first of its languages that the page has, or English", () => {
  const expected = { "fr-FR, pt-PT, en": "pt", "fr, EN-us, pt": "en", de: "en", "ptx, en": "en", "": "en" };
  for (const [tags, language] of Object.entries(expected)) assert.equal(languageFor(...tags.split(", ")), language, tags);
});

test("the last of two languages chosen during loading is shown", async () => {
  await Promise.all([setLanguage("pt"), setLanguage("en")]);
  assert.equal(language(), "en");
  await Promise.all([setLanguage("en"), setLanguage("pt")]);
  assert.equal(language(), "pt");
  assert.equal(t("undo"), pt.undo);
  await setLanguage("en");
});

test("numbers are written in the language, without a negative zero, and in fields without grouping", async () => {
  assert.deepEqual([formatNumber(1234.5, 1), formatNumber(-0, 0), formatTyped(1234.5, 2), formatTyped(2, 1)], ["1,234.5", "0", "1234.5", "2"]);
  await setLanguage("pt");
  assert.deepEqual([formatNumber(1234.5, 1), formatTyped(1234.5, 2), formatTyped(-0.5, 1)], ["1.234,5", "1234,5", "-0,5"]);
  await setLanguage("en");
});

/** Error codes that the modules, the worker and the page can throw. */
async function allCodes() {
  /** @type {Set<string>} */
  const found = new Set();
  for (const { folder, files, codes } of SOURCES) {
    for (const name of await readdir(path.join(ROOT, folder), { recursive: true })) {
      if (!files.test(name)) continue;
      const source = await readFile(path.join(ROOT, folder, name), "utf8");
      for (const [, code] of source.matchAll(codes)) found.add(code);
    }
  }
  return found;
}
