/** Plain English in docs, comments, names and words. PROSE_FILES="a.md b.rs" checks these files alone. */

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT, described, filesWithProse, hitsIn } from "./check.mjs";

/** Texts with one phrase each, with the path that chooses the rules, the line and the start of the suggestion. */
const PLANTED = [
  { kind: "Rust doc comment", file: "a.rs", text: "\n/// What the mesh holds.\nfn held() {}\n", line: 2, suggestion: "name the thing" },
  { kind: "clap help line", file: "args.rs", text: "#[arg(long)]\n/// So many threads at most\njobs: usize,\n", line: 2, suggestion: "the parameter's name" },
  { kind: "Rust test name", file: "b.rs", text: "#[test]\nfn a_file_that_is_no_picture_fails() {}\n", line: 2, suggestion: "a plain name" },
  { kind: "JavaScript comment", file: "a.js", text: "// Waits for\n// whoever asks.\n", line: 2, suggestion: "'anyone who'" },
  { kind: "wrapped JavaScript comment", file: "b.js", text: "/**\n * A file that is\n * no picture.\n */\n", line: 2, suggestion: "'is not a'" },
  { kind: "JavaScript test name", file: "a.test.mjs", text: 'test("where nothing is drawn, it says so");\n', line: 1, suggestion: "name what is tested" },
  { kind: "Python docstring", file: "a.py", text: 'def solve():\n    """Solves anew."""\n', line: 2, suggestion: "'again'" },
  { kind: "Markdown line", file: "a.md", text: "# Faces\n\nFaces beside ours.\n", line: 3, suggestion: "'next to'" },
  { kind: "Markdown list item", file: "b.md", text: "- Where a vertex lies\n", line: 1, suggestion: "name the place" },
  { kind: "TOML comment", file: "a.toml", text: "a = 1\n# Of several the first counts.\n", line: 2, suggestion: "name the thing first" },
  { kind: "English word", file: "web/words/en.json", text: '{\n  "undo": "Edit taken back"\n}\n', line: 2, suggestion: "'undone'" },
  { kind: "English label", file: "web/words/en.json", text: '{\n  "view": "Turn slowly"\n}\n', line: 2, suggestion: '": "Auto-rotate"' },
  { kind: "Portuguese word", file: "web/words/pt.json", text: '{\n  "share": "Enviar"\n}\n', line: 2, suggestion: "Compartilhar" },
];

test("the text is plain English", () => {
  const chosen = process.env["PROSE_FILES"]?.split(/\s+/).filter(Boolean);
  const files = chosen ?? filesWithProse();
  const hits = files.flatMap((file) => hitsIn(file, readFileSync(join(ROOT, file), "utf8")));
  const totals = new Map();
  for (const { rule } of hits) totals.set(rule, (totals.get(rule) ?? 0) + 1);
  const table = [...totals].toSorted(([, one], [, other]) => other - one).map(([rule, count]) => `${String(count).padStart(5)}  ${rule}`);
  const report = [...hits.map(described), "", ...table, `${String(hits.length).padStart(5)}  in ${files.length} files`];
  assert.ok(hits.length === 0, report.join("\n"));
});

for (const { kind, file, text, line, suggestion } of PLANTED) {
  test(`a planted ${kind} is found`, () => {
    const [hit, ...more] = hitsIn(file, text);
    assert.deepEqual(more, []);
    assert.equal(hit?.file, file);
    assert.equal(hit.line, line);
    assert.ok(hit.suggestion.startsWith(suggestion), described(hit));
  });
}

test("code, questions and Portuguese words pass", () => {
  const code = "fn first<T>(of: T) -> bool\nwhere T: Clone {\n    let told = tell(of);\n    told.is_none()\n}\n";
  assert.deepEqual(hitsIn("a.rs", code), []);
  assert.deepEqual(hitsIn("a.md", "## What is Rosto?\n\nThere is no server, and the mesh is no longer shown.\n"), []);
  assert.deepEqual(hitsIn("web/words/pt.json", '{ "a": "So nobody" }'), []);
});
