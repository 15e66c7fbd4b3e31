/** The search for landmarks by name. */

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "./load.mjs";

const { bestMatch, findVertex, landmarkLabel, setPointNumbersShown, setLanguage } = await load("words/names.ts", "words/words.ts");

/** Ids of some landmarks; their numbers are their places. */
const IDS = ["right-cheek-0", "nose-tip", "chin-crease", "left-mouth-corner", "bottom-of-the-chin"];

/** Queries and their expected matches among the names of all landmarks. */
const FOUND = {
  en: { nose: /^nose tip$/, "NOSE TIP": /^nose tip$/, chin: /chin/, "left eye": /^left .*eye/, "eyelid left": /^left .*eyelid/, "mouth corner": /mouth corner/, columel: /columella/ },
  pt: { nariz: /nariz/, queixo: /queixo/, "ponta do nariz": /^ponta do nariz$/, "olho esquerdo": /olho esquerdo/, labio: /lábio/, MAÇÃ: /maçã/ },
};

test("matches rank whole names first, then prefixes, words and parts; the shortest wins", () => {
  const names = ["left outer chin · 9", "chin crease · 18", "chinless · 3", "deep chin · 4", "chin · 199", "right chin line · 2", "Ação · 5"];
  const found = ["chin", "chin 199", "chin c", "outer left", "hin", "acao", "· 5", "beard", "", " · "].map((text) => names[bestMatch(text, names) ?? -1]);
  const expected = ["chin · 199", "chin · 199", "chin crease · 18", "left outer chin · 9", "chin · 199", "Ação · 5", "Ação · 5", undefined, undefined, undefined];
  assert.deepEqual(found, expected);
});

for (const [language, queries] of Object.entries(FOUND)) {
  test(`a search ignores case and accents: ${language}`, async () => {
    const words = JSON.parse(await readFile(new URL(`../../web/words/${language}.json`, import.meta.url), "utf8"));
    const names = Object.entries(words).flatMap(([key, name]) => (/^(landmark\.\w+-|part\.)/.test(key) ? [name] : []));
    assert.ok(names.length > 100, `${names.length} names`);
    for (const [query, expected] of Object.entries(queries)) assert.match(names[bestMatch(query, names) ?? -1] ?? "", expected, query);
  });
}

test("a number is a vertex that can be selected, a text the landmark of that name", async () => {
  const find = (query, count = 468) => findVertex(query, IDS, count);
  assert.deepEqual([find("152"), find(" 7 "), find("0"), find("467"), find("468"), find("7000", 28_881)], [152, 7, 0, 467, undefined, 7000]);
  assert.deepEqual([find("nose tip"), find("nose tip 1"), find("chin"), find("moustache"), find("")], [1, 1, 2, undefined, undefined]);
  await setLanguage("pt");
  assert.equal(find("ponta do nariz"), 1);
  await setLanguage("en");
});

test("labels have the anatomical name or the part, with the number for experts", () => {
  assert.deepEqual(IDS.slice(0, 2).map((id, number) => landmarkLabel(id, number)), ["right cheek", "nose tip"]);
  setPointNumbersShown(true);
  assert.deepEqual(IDS.slice(0, 2).map((id, number) => landmarkLabel(id, number)), ["right cheek · 0", "nose tip · 1"]);
  setPointNumbersShown(false);
});
