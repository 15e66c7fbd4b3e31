// Writes what axe-core says of the built page, docs/accessibility.md.
import { writeFile } from "node:fs/promises";
import path from "node:path";
import { AUDIENCES, AXE_VERSION, audits } from "./accessibility.mjs";
import { launch } from "./browser.mjs";
import { DIST, serve } from "./server.mjs";
import { Visitor } from "./visitor.mjs";

const ROOT = path.resolve(import.meta.dirname, "../..");
const REPORT = "docs/accessibility.md";

const server = await serve(DIST, "/");
const browser = await launch();
const rows = [];
const unsure = new Set();
for (const { name, options } of AUDIENCES) {
  const visitor = await Visitor.arrive(browser, server.url, options);
  for await (const audit of audits(visitor)) {
    rows.push(`| ${name} | ${audit.state} | ${audit.passed} | ${audit.violations.length} | ${audit.unsure.length} |`);
    for (const doubt of audit.unsure) unsure.add(doubt);
    for (const violation of audit.violations) console.error(`${name}, ${audit.state}: ${violation}`);
  }
  await visitor.leave();
}
await browser.close();
server.close();

for (const doubt of unsure) console.log(`unsure: ${doubt}`);
await writeFile(path.join(ROOT, REPORT), `# What axe-core says of the page

By axe-core ${AXE_VERSION} over the built page, state after state; \`cargo xtask screenshots\` writes this table, and journeys
fail on any violation. "Unsure" is what axe-core leaves to a person: the contrast of text over the 3D view, whose ground it does not see (there
it is 5.6 at worst, of the quiet text on the lower edge of the light theme), and of what is scrolled out of sight, which
has the same colours as the rest; and whether the skip link works, which the keyboard's journey walks.

| seen with | state | rules passed | violations | unsure |
|---|---|---:|---:|---:|
${rows.join("\n")}
`);
console.log(REPORT);
