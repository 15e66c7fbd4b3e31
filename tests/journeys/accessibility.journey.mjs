import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { alike, test } from "./fixtures.mjs";
import { openGroup } from "./groups.mjs";

const AXE = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

const SIZES = { phone: { width: 390, height: 844 }, desktop: { width: 1440, height: 900 } };

/** The page's policy lets in no script but its own, so axe-core needs it lifted. */
const AUDIENCES = Object.entries(SIZES).flatMap(([device, viewport]) =>
  ["light", "dark"].map((colorScheme) => ({
    name: `${device}, ${colorScheme}`,
    options: { viewport, colorScheme, bypassCSP: true },
  })),
);

const SECTIONS = ["photo", "landmark", "face", "view", "history", "export", "paper"];

for (const [{ name, options }, tag] of alike(AUDIENCES)) {
  test(`axe-core finds nothing to object to: ${name}`, { tag }, async ({ open }) => {
    let passed = 0;
    for await (const audit of audits(await open(options))) {
      assert.deepEqual(audit.violations, [], audit.state);
      passed += audit.passed;
    }
    assert.ok(passed > 100, `axe-core looked at next to nothing: ${passed} rules passed`);
  });
}

/**
 * Results of axe-core for each state of the page that a visitor sees.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @returns {AsyncGenerator<{ state: string, passed: number, violations: string[] }>}
 */
async function* audits(visitor) {
  const { page } = visitor;
  await visitor.untilLoaded();
  yield await audit(page, "empty");
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 5);
  for (const section of SECTIONS) {
    await visitor.unfold(`section-${section}`);
    if (section === "paper") await runPaper(page);
    yield await audit(page, section);
  }
  for (const dialog of ["keys", "credits"]) {
    await page.evaluate((id) => document.getElementById(id).showModal(), dialog);
    yield await audit(page, dialog);
    await page.keyboard.press("Escape");
  }
  await openGroup(visitor);
  await visitor.download("save-project");
  yield await audit(page, "faces to choose from, after a download");
  await visitor.drop(new Uint8Array(), "nothing.jpg");
  await visitor.notice();
  yield await audit(page, "notice");
}

/** @param {import("@playwright/test").Page} page */
async function runPaper(page) {
  await page.click("[data-action='run-paper']");
  await page.waitForSelector("#paper-results:not([hidden])", { timeout: 150_000 });
}

/** @param {import("@playwright/test").Page} page @param {string} state */
async function audit(page, state) {
  await page.evaluate(AXE);
  const found = await page.evaluate(async () => {
    const { passes, violations } = await globalThis.axe.run(document);
    const list = (results) => results.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
    return { passed: passes.length, violations: list(violations) };
  });
  return { state, ...found };
}
