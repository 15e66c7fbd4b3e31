import assert from "node:assert/strict";
import { changedProject } from "./changed-files.mjs";
import { test } from "./fixtures.mjs";

const ENTRIES = 20_000;
/** Generous for a slow machine; the regression that this test covers took minutes. */
const LIMIT_MS = 30_000;

test("a project of 20 000 edits opens, and edits and undo stay fast", async ({ editor, page }) => {
  await editor.move("nose tip", "z", 1);
  const project = changedProject(await editor.download("save-project"), ({ history }) => {
    const [entry] = history.entries;
    const outAndBack = [0.001, -0.001].map((out_m) => ({ ...entry, move: { ...entry.move, offsets: [[0, 0, out_m]] } }));
    history.entries = Array.from({ length: ENTRIES }, (_, place) => outAndBack[place % 2]);
  });
  await inTime("opened", async () => {
    await editor.drop(project, "long.rosto");
    await page.waitForFunction(() => document.getElementById("history").childElementCount > 50);
    await editor.untilFace();
  });
  const found = await editor.meshJson("mm");
  await editor.findLandmark("bottom of the chin");
  await inTime("edited", () => editor.setOffset("y", -6));
  const edited = await editor.meshJson("mm");
  assert.notDeepEqual(edited, found);
  await inTime("slid", () => editor.setSlider("nose-width", 3));
  await inTime("undone", async () => {
    await page.click("#toolbar [data-action='undo']");
    await editor.frames(3);
  });
  assert.deepEqual(await editor.meshJson("mm"), edited);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), found);
  // The list reports how many entries it omits.
  assert.equal((await page.innerText("#history-earlier")).replaceAll(/\D/g, ""), "19900");
});

test("an error in one listener does not affect the others", async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  await page.evaluate(() => {
    const fail = () => { throw new Error("broken"); };
    Object.defineProperty(document.getElementById("landmark-tag"), "value", { get: fail, set: fail });
  });
  await editor.setOffset("y", 4);
  assert.deepEqual(await editor.history(), ["nose tip"]);
  await editor.setOffset("y", 6);
  assert.equal((await editor.history()).length, 2);
  await page.click("#toolbar [data-action='undo']");
  await editor.frames(3);
  assert.equal((await editor.history()).length, 1);
  const edited = await editor.meshJson("mm");
  // The error is reported.
  assert.equal((await editor.notice()).code, "other");
  await editor.reloadAndResume();
  assert.deepEqual(await editor.meshJson("mm"), edited);
});

/** Measures a step with the long project. @param {string} what @param {() => Promise<unknown>} act */
async function inTime(what, act) {
  const started = performance.now();
  await act();
  const took_ms = performance.now() - started;
  console.log(`  ${ENTRIES} edits: ${what} in ${(took_ms / 1000).toFixed(1)} s`);
  assert.ok(took_ms < LIMIT_MS, `${what} in ${took_ms} ms`);
}
