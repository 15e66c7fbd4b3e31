import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

/** Typed texts, and the numbers that they are; in mm. */
const VALID = [["1,5", 1.5], ["1.5", 1.5], ["−2", -2], ["-2", -2], [" 3 mm", 3], ["- ,5mm", -0.5]];
const INVALID = ["abc", "1e9", "", "1.000,5", "0x3", "4 cm", "99", "9".repeat(320)];

test("a number may have a comma, a point, spaces and its unit; other texts are marked and change nothing", async ({ editor, page }) => {
  await editor.findLandmark("1");
  const field = page.locator("#landmark-offset [data-axis='x'] .number-field");
  const type = async (text) => {
    await field.fill("");
    await (text.length > 9 ? field.fill(text) : field.pressSequentially(text));
  };
  for (const [text, value] of VALID) {
    await type(text);
    await expect(field, text).not.toHaveAttribute("aria-invalid");
    assert.equal(await field.inputValue(), text, "the text was changed while it was typed");
    await field.press("Enter");
    await expect(field, text).toHaveValue(String(value));
  }
  const before = { text: await field.inputValue(), work: await editor.work() };
  await editor.unfold("section-landmark");
  for (const text of INVALID) {
    await type(text);
    await expect(field, text).toHaveAttribute("aria-invalid", "true");
    assert.equal(await field.inputValue(), text, "the text was changed while it was typed");
    await field.press("Tab");
    await expect(field, text).toHaveValue(before.text);
    await expect(field, text).not.toHaveAttribute("aria-invalid");
  }
  assert.deepEqual(await editor.work(), before.work, "an invalid text changed the face");
});
