import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";

test.use({ visit: { expert: true } });

test("a search selects by name or number, and only a query without a match is an error, until the text changes", async ({ editor, page }) => {
  for (const [query, expected] of [["columel", /columella/], ["152", /· 152$/], ["nose", /^nose tip · 1$/]]) {
    await editor.findLandmark(query);
    assert.match(await page.inputValue("#landmark-search"), expected);
    assert.ok(await page.isVisible("#landmark-tag"), `${query} is not selected`);
  }
  const look = () => page.locator("#landmark-search").evaluate((field) => {
    const error = document.getElementById("landmark-search-error");
    return { border: getComputedStyle(field).borderTopColor, error: error.hidden ? undefined : [getComputedStyle(error).color, getComputedStyle(error, "::before").content] };
  });
  const fine = await look();
  await editor.findLandmark("moustache");
  const wrong = await look();
  assert.equal(await page.getAttribute("#landmark-search", "aria-invalid"), "true");
  assert.match(await page.innerText("#landmark-search-error"), /moustache/);
  assert.match(await page.innerText("#announcement"), /moustache/);
  assert.equal(await page.inputValue("#landmark-search"), "moustache");
  assert.notEqual(wrong.border, fine.border);
  assert.equal(wrong.border, wrong.error?.[0]);
  assert.match(wrong.error?.[1] ?? "", /!/);
  assert.equal(fine.error, undefined);

  await page.locator("#landmark-search").press("Backspace");
  assert.deepEqual(await look(), fine);
  await editor.findLandmark("moustache");
  assert.deepEqual(await look(), wrong, "a repeated query was not searched");
  await editor.setLanguage("pt");
  assert.match(await page.innerText("#landmark-search-error"), /Nada se chama “moustache”/);
  await editor.findLandmark("999");
  assert.match(await page.innerText("#landmark-search-error"), /999/);
  await editor.findLandmark("");
  assert.equal(await editor.selectedLandmark(), 1, "an empty query changed the selection");
  assert.deepEqual(await look(), fine);
});
