/** Files under docs/ that sources and scripts name. Links between Markdown files are linkinator's. */

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT, filesWithProse } from "../prose/check.mjs";

const NAME = /\bdocs\/[a-z\d/-]+\.(?:md|json|mjs|png|jpg|svg)\b/g;

/** Names in a text whose files do not exist. @param {string} text */
function missing(text) {
  return (text.match(NAME) ?? []).filter((name) => !existsSync(join(ROOT, name)));
}

test("each documentation file named in a source exists", () => {
  const found = filesWithProse().flatMap((file) => missing(readFileSync(join(ROOT, file), "utf8")).map((name) => `${file}: ${name}`));
  assert.deepEqual(found, []);
});

test("a missing file is found", () => {
  const gone = ["docs", "gone.md"].join("/");
  assert.deepEqual(missing(`/// See docs/maths.md and ${gone}.`), [gone]);
});
