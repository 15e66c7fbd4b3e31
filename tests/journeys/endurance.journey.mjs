import assert from "node:assert/strict";
import { changedProject } from "./changed-files.mjs";
import { test } from "./fixtures.mjs";

const ENTRIES = 20_000;
/** More than anything should take here, on a slow machine; the fault it is for took minutes. */
const LIMIT_MS = 30_000;

test("a project of 20 000 edits opens, and edits and undo are as quick as ever", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.move("nose tip", "z", 1);
  const project = changedProject(await editor.download("save-project"), (header) => {
    const [entry] = header.edits.entries;
    header.edits.entries = Array.from({ length: ENTRIES }, (_, place) => {
      const out_m = place % 2 === 0 ? 0.001 : -0.001;
      return { ...entry, move: { ...entry.move, offsets: [[0, 0, out_m]] } };
    });
    return header;
  });
  const opening_ms = await timed(async () => {
    await editor.drop(project, "long.rosto");
    await page.waitForFunction((count) => document.getElementById("history").childElementCount > count, 50);
    await editor.untilFace();
  });
  const found = await editor.meshJson("mm");
  await editor.findLandmark("bottom of the chin");
  const edit_ms = await timed(() => editor.offset("y", -6));
  const edited = await editor.meshJson("mm");
  assert.notDeepEqual(edited, found);
  const slide_ms = await timed(() => editor.slide("nose-width", 3));
  const undo_ms = await timed(async () => {
    await page.click("#toolbar [data-action='undo']");
    await editor.frames(3);
  });
  assert.deepEqual(await editor.meshJson("mm"), edited);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await editor.meshJson("mm"), found);
  const seconds = [opening_ms, edit_ms, slide_ms, undo_ms].map((ms) => `${(ms / 1000).toFixed(1)} s`);
  console.log(`  ${ENTRIES} edits: opened in ${seconds[0]}; an edit ${seconds[1]}, a slider ${seconds[2]}, undo ${seconds[3]}`);
  for (const ms of [opening_ms, edit_ms, slide_ms, undo_ms]) assert.ok(ms < LIMIT_MS, `${ms} ms`);
  // What is listed is said to be a part of it.
  assert.match((await page.locator("#history .earlier").innerText()).replaceAll(/\D/g, ""), /^19900$/);
});

test("an offset without measure goes to the slider's end", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.findLandmark("nose tip");
  for (const [typed, taken] of /** @type {const} */ ([["1e308", 40], ["-1e308", -40], ["1e309", 40]])) {
    const field = page.locator("#landmark-sliders [data-axis='z'] input[type=number]");
    await field.evaluate((input, typed) => {
      input.value = typed;
      input.dispatchEvent(new Event("input"));
      input.dispatchEvent(new Event("change"));
    }, typed);
    await editor.frames(3);
    const value = Number(await field.inputValue());
    // A number that is none to the browser is no number typed.
    assert.ok(value === taken || (typed === "1e309" && value === 0), `${typed}: ${value}`);
    const { positions } = await editor.meshJson("mm");
    assert.ok(positions.flat().every((place) => Number.isFinite(place) && Math.abs(place) < 1_000));
    assert.doesNotMatch(await page.locator("body").innerText(), /∞|NaN|e\+/);
  }
  assert.ok(await page.isHidden("#notice"));
});

test("a panel that fails does not keep the others from what they show", { tag: "@rare" }, async ({ editor, page }) => {
  // The landmark panel comes long before the history.
  await page.evaluate(() => document.getElementById("landmark-anchors").remove());
  await editor.slide("nose-width", 4);
  assert.deepEqual(await editor.history(), ["Nose width"]);
  await editor.slide("nose-width", 0);
  assert.equal((await editor.history()).length, 2);
  await page.click("#toolbar [data-action='undo']");
  await editor.frames(3);
  assert.equal((await editor.history()).length, 1);
  assert.equal(await editor.sliderValue("nose-width"), 4);
  // What could not be shown is said.
  assert.equal((await editor.notice()).code, "other");
  await editor.comeBack();
  assert.equal(await editor.sliderValue("nose-width"), 4);
});

test("on a dense mesh a point that is not there is not said to be between 0 and 467", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.unfold("section-landmark");
  await page.check("input[name='selection'][value='point']", { force: true });
  await page.selectOption("#point-density", "2");
  // The denser mesh comes after the words that announce it have been drawn.
  await editor.frames(3);
  await editor.findLandmark("7000");
  assert.equal(await editor.point(), 7_000);
  for (const language of ["en", "pt"]) {
    await page.selectOption("#language", language);
    await editor.findLandmark("999999");
    const help = await page.innerText("#landmark-help");
    assert.match(help, /999999/);
    assert.doesNotMatch(help, /467/);
    assert.doesNotMatch(await page.innerText("#section-landmark"), /\b467\b/);
    assert.ok(await page.isHidden("#notice"));
  }
});

test("what the module hands out is given back: 200 edits and undos leave no objects behind", { tag: "@rare" }, async ({ editor, page }) => {
  await page.evaluate(countObjects);
  await editor.move("nose tip", "z", 1);
  const before = await page.evaluate("objects()");
  await page.evaluate(async () => {
    const input = document.querySelector("#landmark-sliders [data-axis='z'] input[type=number]");
    for (let turn = 0; turn < 100; turn += 1) {
      input.value = String(2 + (turn % 7));
      input.dispatchEvent(new Event("input"));
      input.dispatchEvent(new Event("change"));
      if (turn % 2 === 1) document.querySelector("#toolbar [data-action='undo']").click();
      await new Promise(requestAnimationFrame);
    }
    for (let turn = 0; turn < 50; turn += 1) document.querySelector("#toolbar [data-action='undo']").click();
  });
  await editor.frames(3);
  const after = await page.evaluate("objects()");
  assert.ok(after.StudioEntry.made > 1_000, `${after.StudioEntry?.made} entries were shown`);
  for (const [name, { made, freed }] of Object.entries(after)) {
    const alive = made - freed;
    const earlier = before[name] ? before[name].made - before[name].freed : 0;
    assert.ok(alive <= earlier, `${alive} objects of ${name} are alive, ${earlier} were before`);
  }
});

/** @param {() => Promise<unknown>} act */
async function timed(act) {
  const started = performance.now();
  await act();
  return performance.now() - started;
}

/** Runs in the page: counts what the module hands out, and what is given back, in `objects()`. */
async function countObjects() {
  const module = await import(new URL("wasm/rosto-studio-web.js", document.baseURI).href);
  const counts = {};
  for (const [name, type] of Object.entries(module)) {
    if (typeof type !== "function" || typeof type.__wrap !== "function") continue;
    const count = { made: 0, freed: 0 };
    counts[name] = count;
    const { __wrap: wrap } = type;
    type.__wrap = (...values) => {
      count.made += 1;
      return wrap.apply(type, values);
    };
    const { free } = type.prototype;
    type.prototype.free = function () {
      count.freed += 1;
      return free.call(this);
    };
  }
  globalThis.objects = () => structuredClone(counts);
}
