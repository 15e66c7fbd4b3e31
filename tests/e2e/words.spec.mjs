import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import path from "node:path";
import { test } from "./fixtures.mjs";
import { delayFile } from "./delayed-file.mjs";
import { importParts } from "./parts.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const words = ["en", "pt"].map((language) => readFile(path.join(ROOT, `web/words/${language}.json`), "utf8"));
const [en, pt] = (await Promise.all(words)).map((text) => JSON.parse(text));

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

test("notices do not show the modules' English messages", async ({ open }) => {
  const visitor = await open({ locale: "pt-BR" });
  const { page } = visitor;
  await visitor.untilLoaded();
  const parts = await importParts(page, ["src/page/notice.ts", "src/words/words.ts"]);
  const shown = await parts.evaluate(async ({ showError, loadWords }) => {
    await loadWords("pt");
    const thrown = (code) => Object.assign(new Error("no landmark is held"), { code, hint: "Choose a landmark first." });
    return ["no-selection", "from-a-later-version"].map((code) => {
      showError(thrown(code));
      return ["notice-title", "notice-hint"].map((id) => document.getElementById(id).innerText);
    });
  });
  assert.deepEqual(shown, [
    [pt["error.no-selection"], pt["error.no-selection.hint"]],
    [pt["error.other"], pt["error.other.hint"]],
  ]);
});

test("buttons stay hidden until their text has loaded", async ({ open }) => {
  const { before, deliver } = delayFile("**/page.js");
  const visitor = await open({ before, waitUntil: "commit" });
  const seen = visitor.page.locator("#welcome button:visible");
  assert.equal(await seen.count(), 0);
  deliver();
  await visitor.untilInteractive();
  assert.equal(await seen.count(), 4);
});

test("the last of two languages chosen during loading is shown", async ({ open }) => {
  const { before, deliver } = delayFile("**/pt-*.js");
  const visitor = await open({ before });
  const { page } = visitor;
  await visitor.untilInteractive();
  await page.selectOption("#language", "pt");
  await page.selectOption("#language", "en");
  const arrived = page.waitForResponse("**/pt-*.js");
  deliver();
  await (await arrived).finished();
  await visitor.frames(10);
  assert.equal(await page.getAttribute("html", "lang"), "en");
  await page.selectOption("#language", "pt");
  await page.waitForSelector("html[lang='pt-BR']", { state: "attached" });
});

test("hints do not promise saved work if the browser does not save it", async ({ visitor }) => {
  await visitor.untilLoaded();
  const parts = await importParts(visitor.page, ["src/page/notice.ts"]);
  const hints = await parts.evaluate(({ setSavesWork, showError }) => {
    const hint = () => document.getElementById("notice-hint").textContent;
    showError({ code: "device-lost", message: "", hint: "" });
    const kept = hint();
    setSavesWork(false);
    const unkept = hint();
    setSavesWork(true);
    return { kept, unkept, again: hint() };
  });
  assert.match(hints.kept, /Your work is saved/);
  assert.doesNotMatch(hints.unkept, /saved/);
  assert.equal(hints.again, hints.kept);
  const promises = Object.keys(en).filter((key) => /\.hint$/.test(key) && /work is saved|reload the page to continue/i.test(en[key]));
  assert.ok(promises.length > 0);
  for (const key of promises) assert.ok(`${key}.unkept` in en, key);
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
