import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFile } from "node:fs/promises";
import { journey } from "./journey.mjs";

const AXE = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

for (const [size, viewport] of Object.entries({ desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } })) {
  for (const colorScheme of ["light", "dark"]) {
    journey(`axe-core finds nothing to object to: ${size}, ${colorScheme}`, async (open) => {
      const visitor = await open({ viewport, colorScheme, bypassCSP: true });
      await visitor.untilLoaded();
      await expectNoViolations(visitor.page, "empty");
      await visitor.dropSample();
      await visitor.findLandmark("nose tip");
      await visitor.offset("z", 5);
      for (const section of ["section-landmark", "section-view", "section-export"]) {
        await visitor.unfold(section);
        await expectNoViolations(visitor.page, section);
      }
      await visitor.page.evaluate(() => document.getElementById("credits").showModal());
      await expectNoViolations(visitor.page, "credits");
    });
  }
}

/**
 * @param {import("playwright-core").Page} page
 * @param {string} state
 */
async function expectNoViolations(page, state) {
  await page.evaluate(AXE);
  const violations = await page.evaluate(async () => {
    const results = await globalThis.axe.run(document, { resultTypes: ["violations"] });
    return results.violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.target.join(" ")).join(", ")}`);
  });
  assert.deepEqual(violations, [], state);
}
