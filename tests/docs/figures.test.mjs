/** The measured figures of the documentation are those of the data files. */

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { parse } from "node-html-parser";
import { ROOT, figures, filled, pages, unmarked } from "../../docs/figures.mjs";
import { html, reader } from "../../docs/site/markdown.mjs";

/** Pages about figures, on which lengths and shares need marks, too. */
const STRICT = ["README.md", "docs/accuracy.md", "docs/benchmarks.md"];

/** Limits, parameters and published values that are not measured here, by page. @type {Record<string, string[]>} */
const CONSTANTS = {
  "README.md": ["about 20 minutes and 3 GB of disk", "about 40 minutes and 12 GB", "an error of 5 %"],
  "docs/accuracy.md": [
    "people vary by 4 %",
    "the stated 90 % interval",
    "62 px between the eyes",
    "below 10 % of the distance",
    "24 to 720 px between the eyes",
    "64 to 1500 px",
    "differ by 1 % on",
    "cut by 40 % or more",
    "above 6 mm",
    "200 px a second",
    "300 px a second",
  ],
  "docs/fuzzing.md": ["more than 2 s", "more than 64 MB", "claimed 4.3 GB"],
  "docs/live-camera.md": ["about 33 ms per frame", "Above 67 ms"],
  "docs/texture.md": ["1.25 times brighter, 1.55 times darker, or 1.15 times redder"],
  "docs/decisions/0004-own-icc-reader.md": ["10 to 21 kB", "at least 44 kB", "was 30 kB"],
};

const known = await figures();
const read = async (/** @type {string} */ path) => ({ path, text: await readFile(join(ROOT, path), "utf8") });
const texts = await Promise.all((await pages()).map(read));

test("each marked figure is that of the data; `node docs/figures.mjs` updates them", () => {
  for (const { path, text } of texts) {
    const expected = filled(text, known).split("\n");
    for (const [at, line] of text.split("\n").entries()) assert.equal(line, expected[at], `${path}:${at + 1}`);
  }
});

test("each measured figure has a mark", () => {
  const missing = texts.flatMap(({ path, text }) => {
    const found = unmarked(text, CONSTANTS[path] ?? [], { strict: STRICT.includes(path) });
    return found.length > 0 ? [`${path}: ${found.join(", ")}`] : [];
  });
  assert.deepEqual(missing, [], "mark these figures, as docs/figures.mjs describes, or list them in CONSTANTS");
});

test("no constant is left over", () => {
  const words = new Map(texts.map(({ path, text }) => [path, text.replaceAll(/\s+/g, " ")]));
  for (const [path, phrases] of Object.entries(CONSTANTS)) {
    for (const phrase of phrases) assert.ok(words.get(path)?.includes(phrase), `${path} does not contain "${phrase}"`);
  }
});

test("a figure that differs by one digit is found, in a sentence and in a table", () => {
  const own = new Map([
    ["edit/468 vertices/rosto", { value: 0.9724, unit: "ms", subject: "edit/468 vertices" }],
    ["edit/468 vertices/numpy", { value: 144.6, unit: "ms", subject: "edit/468 vertices" }],
  ]);
  const right = [
    "0.97 ms<!-- edit/468 vertices/rosto -->",
    "972 µs<!-- edit/468 vertices/rosto -->",
    "149 times<!-- edit/468 vertices/NumPy ÷ rosto -->",
    "<!-- figures: edit/{row}/{column} -->\n\n| | Rosto | NumPy |\n|---|---:|---:|\n| 468 vertices | 1.0 ms | 145 |\n",
  ];
  for (const text of right) assert.equal(filled(text, own), text);
  const changes = [["0.97", "0.98"], ["972", "971"], ["149", "148"], ["1.0", "1.1"], ["145", "144"]];
  const wrong = changes.map(([from, to], at) => right[Math.min(at, 3)].replace(from, to));
  for (const text of wrong) assert.ok(right.includes(filled(text, own)), text);
});

test("a mark with an unknown key, another dimension or no figure is refused", () => {
  const figure = (/** @type {string} */ unit) => ({ value: 2, unit, subject: "" });
  const own = new Map([["a", figure("ms")], ["b", figure("px")]]);
  for (const text of ["2 ms<!-- c -->", "2 MB<!-- a -->", "two<!-- a -->", "1 ×<!-- a ÷ b -->"]) {
    assert.throws(() => filled(text, own), Error, text);
  }
});

test("a figure without a mark is found, and code, formulas and constants are not", () => {
  for (const text of ["takes 12 ms", "4.9 MB", "7 times as fast", "150× faster", "an hour or 2 h"]) {
    assert.equal(unmarked(text, []).length, 1, text);
  }
  const others = ["`12 ms`", "```\n12 ms\n```\n", "640 × 480 px", "$12 s$", "12 ms<!-- a -->", "at most 40 MB"];
  for (const text of others) assert.deepEqual(unmarked(text, ["at most 40 MB"]), [], text);
  const strict = ["1.4 mm", "12 %", "| 1.4 | 2 |"];
  for (const text of strict) assert.equal(unmarked(text, [], { strict: true }).length, 1, text);
});

test("marks are invisible on the site", () => {
  const table = "<!-- figures: edit/{row} -->\n\n| a | b |\n|---|---|\n| c | 1 ms<!-- edit/c --> |\n";
  const text = `A tick takes 0.4 µs<!-- edit/tick -->.\n\n${table}`;
  const shown = parse(html(reader(), text, () => undefined));
  assert.equal(shown.querySelector("p")?.textContent, "A tick takes 0.4 µs.");
  assert.deepEqual(shown.querySelectorAll("td").map((cell) => cell.textContent), ["c", "1 ms"]);
  assert.ok(!shown.textContent.includes("edit/"));
});

test("each accuracy figure has a value, a sample and a protocol", async () => {
  const accuracy = JSON.parse(await readFile(join(ROOT, "docs/accuracy.json"), "utf8"));
  for (const figure of accuracy.figures) {
    const name = JSON.stringify(figure);
    assert.ok(Number.isFinite(figure.value) && Number.isInteger(figure.samples) && typeof figure.unit === "string", name);
    assert.equal(typeof accuracy.protocols[figure.task]?.sample, "string", name);
  }
});
