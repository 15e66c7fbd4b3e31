import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { importParts } from "./parts.mjs";

const pt = JSON.parse(await readFile(new URL("../../web/words/pt.json", import.meta.url), "utf8"));

test("notices do not show the modules' English messages", async ({ open }) => {
  const visitor = await open({ locale: "pt-BR" });
  const { page } = visitor;
  await visitor.untilLoaded();
  const parts = await importParts(page, ["src/page/notice.ts", "src/words/words.ts"]);
  const shown = await parts.evaluate(async ({ showError, loadWords }) => {
    await loadWords("pt");
    const thrown = (code) => Object.assign(new Error("no landmark is held"), { code, hint: "Choose a landmark first." });
    return ["no-selection", "from-a-later-version"].map((code) => {
      showError(thrown(code));
      return ["notice-title", "notice-hint"].map((id) => document.getElementById(id).innerText);
    });
  });
  assert.deepEqual(shown, [
    [pt["error.no-selection"], pt["error.no-selection.hint"]],
    [pt["error.other"], pt["error.other.hint"]],
  ]);
});

test("hints do not promise saved work if the browser does not save it", async ({ visitor }) => {
  await visitor.untilLoaded();
  const parts = await importParts(visitor.page, ["src/page/notice.ts"]);
  const hints = await parts.evaluate(({ setSavesWork, showError }) => {
    const hint = () => document.getElementById("notice-hint").textContent;
    showError({ code: "device-lost", message: "", hint: "" });
    const kept = hint();
    setSavesWork(false);
    const unkept = hint();
    setSavesWork(true);
    return { kept, unkept, again: hint() };
  });
  assert.match(hints.kept, /Your work is saved/);
  assert.doesNotMatch(hints.unkept, /saved/);
  assert.equal(hints.again, hints.kept);
});
