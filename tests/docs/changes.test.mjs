/** The lists of CONTRIBUTING: the files to start with for a common change. */

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ROOT } from "../prose/check.mjs";

/** Most files of each change, without words. */
const MOST = { "A slider": 1, "An intent": 4, "An option of `rosto mesh`": 3 };

const GUIDE = readFileSync(join(ROOT, "CONTRIBUTING.md"), "utf8");

/** The path that each numbered item of a section starts with. @param {string} guide @param {string} title */
function paths(guide, title) {
  const section = guide.split(`### ${title}\n`)[1]?.split("\n### ")[0] ?? "";
  const items = section.split(/^\d+\. /m).slice(1);
  return items.flatMap((item) => item.split("\n\n")[0].match(/`((?:crates|web|tests)\/[\w/.-]+)`/)?.slice(1, 2) ?? []);
}

/** @param {string} path */
function isThere(path) {
  return existsSync(join(ROOT, path));
}

for (const [title, most] of Object.entries(MOST)) {
  test(`the list for “${title}” has at most ${most} files, which exist`, () => {
    const found = paths(GUIDE, title);
    assert.ok(found.length > 0 && found.length <= most, `${found.length} files`);
    assert.deepEqual(found.filter((path) => !isThere(path)), []);
  });
}

test("a further file is counted, and a missing one found", () => {
  const planted = GUIDE.replace("### A slider\n", "### A slider\n\n1. `crates/gone.rs`: a file.\n");
  assert.deepEqual(paths(planted, "A slider").map(isThere), [false, true]);
});
