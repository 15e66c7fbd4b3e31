// The page's Shape panel in <rosto-studio>.
import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./element-visitor.mjs";

test("with the attribute panel, the element shows the page's shape panel, and each one edits its own face", async ({ openElement }) => {
  const element = (id) => `<rosto-studio id="${id}" panel controls density="0" src="portrait.png"></rosto-studio>`;
  const body = `${element("one")}${element("other")}<button data-action="undo" data-of="host">Mine</button>`;
  const visitor = await openElement({ body });
  const { page } = visitor;
  await visitor.until("rosto-face", 2);
  const panel = (id) => page.locator(`#${id} .panel`);
  const states = () => page.evaluate(() => ["one", "other"].map((id) => document.getElementById(id).state.sliders_mm["nose-width"]));

  for (const [id, mm] of [["one", "3"], ["other", "1.5"]]) {
    const field = panel(id).locator("#slider-nose-width .number-field");
    await field.fill(mm);
    await field.press("Enter");
  }
  assert.deepEqual(await states(), [3, 1.5]);
  assert.equal((await visitor.names()).filter((name) => name === "rosto-change").length, 2);
  await panel("one").locator("#section-history > summary").click();
  await panel("one").getByRole("button", { name: "Undo", exact: true }).click();
  assert.deepEqual(await states(), [0, 1.5]);
  assert.ok(await page.isEnabled("[data-of=host]"), "a button of the host page is disabled");

  await visitor.act((face) => face.setAttribute("lang", "pt"));
  await expect(panel("one").locator("#shape legend")).toHaveText("Parte do rosto");
  await visitor.act((face) => face.removeAttribute("panel"));
  await expect(panel("one")).toBeHidden();
});
