import assert from "node:assert/strict";
import { variants, test } from "./fixtures.mjs";
import { importParts } from "./parts.mjs";

test.use({ visit: { expert: true } });

/** Queries and their expected matches. */
const FOUND = {
  en: [
    ["nose", /^nose tip · 1$/],
    ["NOSE TIP", /^nose tip · 1$/],
    ["nose tip 1", /^nose tip · 1$/],
    ["chin", /chin/],
    ["left eye", /^left .*eye/],
    ["eyelid left", /^left .*eyelid/],
    ["mouth corner", /mouth corner/],
    ["columel", /columella/],
    ["152", /· 152$/],
    ["7", /· 7$/],
  ],
  pt: [
    ["nariz", /nariz/],
    ["queixo", /queixo/],
    ["ponta do nariz", /^ponta do nariz · 1$/],
    ["olho esquerdo", /olho esquerdo/],
    ["labio", /lábio/],
    ["MAÇÃ", /maçã/],
    ["0", /· 0$/],
  ],
};

for (const [[language, queries], tag] of variants(Object.entries(FOUND))) {
  test(`a search finds the best match, ignoring case and accents: ${language}`, { tag }, async ({ editor, page }) => {
    await editor.setLanguage(language);
    for (const [typed, meant] of queries) {
      await editor.findLandmark(typed);
      assert.match(await page.inputValue("#landmark-search"), meant, typed);
      assert.equal(await page.getAttribute("#landmark-search", "aria-invalid"), null, typed);
      assert.ok(await page.isVisible("#landmark-tag"), `${typed} is not selected`);
    }
  });
}

test("matches rank whole names first, then prefixes, words and parts; the shortest wins", async ({ page }) => {
  const parts = await importParts(page, ["src/words/names.ts"]);
  const found = await parts.evaluate(({ bestMatch }) => {
    const names = ["left outer chin · 9", "chin crease · 18", "chinless · 3", "deep chin · 4", "chin · 199", "right chin line · 2", "Ação · 5"];
    return ["chin", "chin 199", "chin c", "outer left", "hin", "acao", "· 5", "beard", "", " · "].map((text) => names[bestMatch(text, names) ?? -1]);
  });
  const expected = ["chin · 199", "chin · 199", "chin crease · 18", "left outer chin · 9", "chin · 199", "Ação · 5", "Ação · 5", undefined, undefined, undefined];
  assert.deepEqual(found, expected);
});

test("only a query without a match is an error, until the text changes", async ({ editor, page }) => {
  await editor.findLandmark("nose");
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
