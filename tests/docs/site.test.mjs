/** The documentation leads nowhere that is not there, in the repository and as the site that ROSTO_SITE names. */

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { parse } from "node-html-parser";
import { helpAsMarkdown } from "../../docs/site/command-line.mjs";
import { html, reader } from "../../docs/site/markdown.mjs";
import { PAGES } from "../../docs/site/pages.mjs";
import { deadInSite, deadInTexts, textsIn } from "./links.mjs";

const ROOT = join(import.meta.dirname, "../..");
const SITE = process.env["ROSTO_SITE"] ?? join(ROOT, "target/site");

/** @param {string} name */
async function page(name) {
  return parse(await readFile(join(SITE, `${name}.html`), "utf8"));
}

/** @param {(folder: string) => Promise<void>} work */
async function inAFolder(work) {
  const folder = await mkdtemp(join(tmpdir(), "rosto-links-"));
  try {
    await work(folder);
  } finally {
    await rm(folder, { recursive: true });
  }
}

test("no link or picture of the repository's texts is dead", async () => {
  const texts = await textsIn(ROOT);
  assert.ok(texts.length > 30 && texts.includes("README.md") && texts.includes("crates/laplacian/README.md"));
  assert.deepEqual(await deadInTexts(ROOT, texts), []);
});

test("no link or picture of the site is dead, and nothing of it comes from elsewhere", async () => {
  assert.deepEqual(await deadInSite(SITE), []);
});

test("dead links that are planted in a text are found, each of them, and no others", () =>
  inAFolder(async (folder) => {
    const alive = "[file](other.md) [heading](other.md#a-b-c) [own](#top) [web](https://example.org)";
    const dead = ["gone.md", "other.md#gone", "#gone", "../outside.md", "gone.png", "http://plain.example", "gone.svg"];
    const [first, second, third, fourth, picture, plain, html] = dead;
    const links = [first, second, third, fourth, plain].map((address) => `[x](${address})`);
    await writeFile(join(folder, "other.md"), "# Other\n\n## A `b`: [c](#other)\n");
    await writeFile(join(folder, "text.md"), `# Top\n\n${alive}\n\n${links.join(" ")} ![x](${picture}) <img src="${html}">\n`);
    const found = await deadInTexts(folder, ["text.md", "other.md"]);
    assert.deepEqual(found.sort(), dead.map((address) => `text.md: ${address}`).sort());
  }));

test("dead links that are planted in the site are found, and what it would load from elsewhere", () =>
  inAFolder(async (folder) => {
    await cp(SITE, folder, { recursive: true });
    const dead = ["gone.html", "maths.html#gone", "#gone", "images/gone.png", "https://example.org/x.css"];
    const [file, heading, own, picture, style] = dead;
    const links = [file, heading, own].map((address) => `<a href="${address}">x</a>`);
    const planted = `${links.join("")}<img src="${picture}"><link rel="stylesheet" href="${style}">`;
    await writeFile(join(folder, "citing.html"), planted);
    assert.deepEqual(await deadInSite(folder), dead.map((address) => `citing.html: ${address}`));
  }));

test("every text of the documentation is a page, and no page has a script or a style of its own", async () => {
  const texts = (await textsIn(join(ROOT, "docs"))).map((path) => `docs/${path}`);
  const sources = PAGES.map(({ source }) => source);
  assert.deepEqual(texts.filter((text) => !sources.includes(text)), []);
  const files = (await readdir(SITE)).filter((name) => name.endsWith(".html"));
  assert.equal(files.length, PAGES.length);
  for (const { name } of PAGES) {
    const made = await page(name);
    assert.equal(made.querySelectorAll("script, style, iframe").length, 0, name);
    assert.equal(made.querySelectorAll("h1").length, 1, name);
    assert.match(made.querySelector("meta[http-equiv]")?.getAttribute("content") ?? "", /^default-src 'none'/, name);
  }
});

test("the paper's seven equations are mathematics, and none is left as it was written", async () => {
  const maths = await page("maths");
  const numbers = maths.querySelectorAll('math[display="block"]').flatMap((equation) => /\((\d)\)/.exec(equation.textContent)?.[1] ?? []);
  assert.deepEqual(numbers, ["1", "2", "3", "4", "5", "6", "7"]);
  assert.equal(maths.querySelectorAll(".temml-error, merror").length, 0);
  assert.ok(!maths.querySelector("main")?.textContent.includes("$"));
});

test("the references have every command and every public name", async () => {
  const commands = await page("command-line");
  assert.deepEqual(commands.querySelectorAll("main h2").map((each) => each.textContent), ["landmarks", "mesh", "photo", "paper"].map((name) => `rosto ${name}`));
  const options = commands.querySelectorAll("li > code, li > p > code").map((each) => each.textContent);
  for (const option of ["--jobs <N>", "-o, --output <FILE>", "--solid <SOLID>"]) assert.ok(options.includes(option), option);
  const names = (await page("python-reference")).querySelectorAll("main h2").map((each) => each.textContent);
  const listed = /__all__ = \[([^\]]*)\]/.exec(await readFile(join(ROOT, "crates/python/rosto/__init__.py"), "utf8"))?.[1] ?? "";
  const all = [...listed.matchAll(/"(\w+)"/g)].map(([, name]) => `rosto.${name}`);
  assert.deepEqual(names.toSorted(), all.toSorted());
});

test("a link to what the site does not have is text there, and a page's leads to the page", () => {
  const made = html(reader(), "[a](a.md#b) [c](c.rs) ![d](d.png)", (address) => (address.startsWith("c") ? undefined : `x/${address}`));
  assert.equal(made.trim(), '<p><a href="x/a.md#b">a</a> <span>c</span> <img src="x/d.png" alt="d"></p>');
});

test("what a program says of itself keeps its words, whatever they hold", () => {
  const made = html(reader(), helpAsMarkdown("Usage: x <A>\n\nOptions:\n      --b <C>\n          A_b *c* <d> $e$\n"), () => undefined);
  const shown = parse(made);
  assert.deepEqual(shown.querySelectorAll("li code").map((each) => each.textContent), ["--b <C>"]);
  assert.ok(shown.textContent.includes("A_b *c* <d> $e$"));
});
