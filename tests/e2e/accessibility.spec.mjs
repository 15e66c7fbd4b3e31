import assert from "node:assert/strict";
import axe from "axe-core";
import { variants, test } from "./fixtures.mjs";
import { openGroup } from "./groups.mjs";

const SIZES = { phone: { width: 390, height: 844 }, desktop: { width: 1440, height: 900 } };

const SECTIONS = ["photo", "landmark", "face", "view", "history", "export", "paper"];

for (const [[device, colorScheme], tag] of variants([["phone", "light"], ["phone", "dark"], ["desktop", "light"], ["desktop", "dark"]])) {
  test(`axe-core finds no violations: ${device}, ${colorScheme}`, { tag }, async ({ open }) => {
    const visitor = await open({ viewport: SIZES[device], colorScheme, scripts: [axe.source] });
    const { page } = visitor;
    // The experiment takes long.
    const runsPaper = device === "desktop";
    let passed = 0;
    const audit = async (state) => {
      const { passes, violations } = await page.evaluate("axe.run(document)");
      const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(" ")).join(", ")}`);
      assert.deepEqual(found, [], state);
      passed += passes.length;
    };

    await visitor.untilLoaded();
    await audit("empty");
    await visitor.dropSample();
    await visitor.move("nose tip", "z", 5);
    for (const section of SECTIONS) {
      await visitor.unfold(`section-${section}`);
      if (section === "paper" && runsPaper) {
        await page.click("[data-action='run-paper']");
        await page.waitForSelector("#paper-results:not([hidden])", { timeout: 150_000 });
      }
      await audit(section);
    }
    for (const dialog of ["keys", "credits"]) {
      await page.evaluate((id) => document.getElementById(id).showModal(), dialog);
      await audit(dialog);
      await page.keyboard.press("Escape");
    }
    await openGroup(visitor);
    await visitor.download("save-project");
    await audit("faces to choose from, after a download");
    await visitor.drop(new Uint8Array(), "nothing.jpg");
    await visitor.notice();
    await audit("notice");
    assert.ok(passed > 100, `axe-core checked too little: ${passed} rules passed`);
  });
}
