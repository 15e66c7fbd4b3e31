import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { openGroup } from "./groups.mjs";

const require = createRequire(import.meta.url);
const AXE = await readFile(require.resolve("axe-core/axe.min.js"), "utf8");

export const AXE_VERSION = require("axe-core/package.json").version;

const SIZES = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } };

/** What the page is looked at with. Its policy lets no script in but its own, so axe-core needs it lifted. */
export const AUDIENCES = Object.entries(SIZES).flatMap(([device, viewport]) =>
  ["light", "dark"].map((colorScheme) => ({
    name: `${device}, ${colorScheme}`,
    options: { viewport, colorScheme, bypassCSP: true },
  })),
);

const SECTIONS = ["photo", "landmark", "face", "view", "history", "export", "paper"];

/**
 * What axe-core says of every state of the page that a visitor sees.
 *
 * @param {import("./visitor.mjs").Visitor} visitor
 * @returns {AsyncGenerator<{ state: string, passed: number, unsure: string[], violations: string[] }>}
 */
export async function* audits(visitor) {
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
    const { passes, incomplete, violations } = await globalThis.axe.run(document);
    const list = (results) => results.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
    return { passed: passes.length, unsure: list(incomplete), violations: list(violations) };
  });
  return { state, ...found };
}
