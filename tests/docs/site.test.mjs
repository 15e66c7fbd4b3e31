/** The documentation as the site that ROSTO_SITE names; linkinator follows its links. */

import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { parse } from "node-html-parser";
import { helpAsMarkdown } from "../../docs/site/command-line.mjs";
import { html, isElsewhere, reader } from "../../docs/site/markdown.mjs";
import { PAGES } from "../../docs/site/pages.mjs";

const ROOT = join(import.meta.dirname, "../..");
const SITE = process.env["ROSTO_SITE"] ?? join(ROOT, "target/site");

/** @param {string} name */
async function page(name) {
  return parse(await readFile(join(SITE, `${name}.html`), "utf8"));
}

test("each Markdown file of the documentation is a page without scripts, inline styles or external files", async () => {
  const files = await readdir(join(ROOT, "docs"), { recursive: true });
  const texts = files.filter((path) => path.endsWith(".md")).map((path) => `docs/${path}`);
  const sources = PAGES.map(({ source }) => source);
  assert.deepEqual(texts.filter((text) => !sources.includes(text)), []);
  const made = (await readdir(SITE)).filter((name) => name.endsWith(".html"));
  assert.equal(made.length, PAGES.length);
  for (const { name } of PAGES) {
    const made = await page(name);
    assert.equal(made.querySelectorAll("script, style, iframe").length, 0, name);
    const loaded = made.querySelectorAll("link, [src]").map((each) => each.getAttribute("href") ?? each.getAttribute("src") ?? "");
    assert.deepEqual(loaded.filter(isElsewhere), [], name);
    assert.equal(made.querySelectorAll("h1").length, 1, name);
    assert.match(made.querySelector("meta[http-equiv]")?.getAttribute("content") ?? "", /^default-src 'none'/, name);
  }
});

test("the seven equations of the paper are rendered as MathML", async () => {
  const maths = await page("maths");
  const numbers = maths.querySelectorAll('math[display="block"]').flatMap((equation) => /\((\d)\)/.exec(equation.textContent)?.[1] ?? []);
  assert.deepEqual(numbers, ["1", "2", "3", "4", "5", "6", "7"]);
  assert.equal(maths.querySelectorAll(".temml-error, merror").length, 0);
  assert.ok(!maths.querySelector("main")?.textContent.includes("$"));
});

test("the references list each command and each public name", async () => {
  const commands = await page("command-line");
  assert.deepEqual(commands.querySelectorAll("main h2").map((each) => each.textContent), ["landmarks", "mesh", "photo", "paper"].map((name) => `rosto ${name}`));
  const options = commands.querySelectorAll("li > code, li > p > code").map((each) => each.textContent);
  for (const option of ["--jobs <N>", "-o, --output <FILE>", "--solid <SOLID>"]) assert.ok(options.includes(option), option);
  const names = (await page("python-reference")).querySelectorAll("main h2").map((each) => each.textContent);
  const listed = /__all__ = \[([^\]]*)\]/.exec(await readFile(join(ROOT, "crates/python/rosto/__init__.py"), "utf8"))?.[1] ?? "";
  const all = [...listed.matchAll(/"(\w+)"/g)].map(([, name]) => `rosto.${name}`);
  assert.deepEqual(names.toSorted(), all.toSorted());
});

test("a link to a file outside the site becomes text", () => {
  const made = html(reader(), "[a](a.md#b) [c](c.rs) ![d](d.png)", (address) => (address.startsWith("c") ? undefined : `x/${address}`));
  assert.equal(made.trim(), '<p><a href="x/a.md#b">a</a> <span>c</span> <img src="x/d.png" alt="d"></p>');
});

test("help text with Markdown characters is shown verbatim", () => {
  const made = html(reader(), helpAsMarkdown("Usage: x <A>\n\nOptions:\n      --b <C>\n          A_b *c* <d> $e$\n"), () => undefined);
  const shown = parse(made);
  assert.deepEqual(shown.querySelectorAll("li code").map((each) => each.textContent), ["--b <C>"]);
  assert.ok(shown.textContent.includes("A_b *c* <d> $e$"));
});
