import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { untilSaved } from "./storage.mjs";
import { trapIn } from "./page-scripts.mjs";

test.use({ visit: { scripts: [countCalls] } });

test("after a trap no code calls into the module, before or after a new instance exists", async ({ editor, page }) => {
  await editor.untilLoaded();
  await editor.move("nose tip", "z", 9);
  await editor.meshJson("mm");
  const project = await editor.download("save-project");
  await untilSaved(page);

  await page.evaluate(trapIn, { method: "apply" });
  await page.focus("#viewport");
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction(() => globalThis.modules.isWaiting);
  const calls = await page.evaluate("modules.calls[0]");
  assert.ok(calls > 100, `${calls} calls were counted`);
  await pressEverything(editor);
  await editor.drop(project, "face.rosto");
  await editor.frames(5);
  assert.equal(await page.evaluate("modules.calls[0]"), calls, "the trapped module was called");

  await page.keyboard.press("Escape");
  await page.evaluate("modules.release()");
  await page.waitForSelector("#notice[data-code='restarted']");
  await editor.untilFace();
  await pressEverything(editor);
  // Collects wrappers of the trapped module's objects.
  await page.requestGC();
  await editor.frames(5);
  assert.equal(await page.evaluate("modules.calls[0]"), calls, "the trapped module was called later");
});

/** Uses the page's controls and drags on the face. */
async function pressEverything(editor) {
  const { page } = editor;
  const { x, y, width, height } = await page.locator("#viewport").boundingBox();
  await editor.drag({ x: x + width / 2, y: y + height / 2 }, { x: 20, y: 10 });
  await page.mouse.wheel(0, 40);
  await page.evaluate(() => {
    const inputs = [...document.querySelectorAll("#panel input, #panel select, #toolbar input")].filter(({ type }) => type !== "file");
    for (const input of inputs) for (const type of ["input", "change"]) input.dispatchEvent(new Event(type, { bubbles: true }));
    for (const details of document.querySelectorAll("#panel details")) details.open = !details.open;
    const skipped = "#photo-change, #add-photo, #clip, [data-action='choose'], [data-action='sample']";
    for (const button of document.querySelectorAll(`:is(#panel, #toolbar) button:not(${skipped})`)) button.click();
    for (const key of ["z", "ArrowUp", "Escape"]) {
      const press = new KeyboardEvent("keydown", { key, ctrlKey: key === "z", bubbles: true, cancelable: true });
      document.getElementById("viewport").dispatchEvent(press);
    }
  });
  await editor.frames(5);
}

/** Runs in the page before its scripts: counts calls into each module instance, and delays the second instance. */
function countCalls() {
  const modules = { calls: [], isWaiting: false, release: () => {} };
  const held = new Promise((resolve) => (modules.release = resolve));
  globalThis.modules = modules;
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (module, imports) => {
    const exported = module instanceof WebAssembly.Module ? WebAssembly.Module.exports(module) : [];
    if (!exported.some(({ name }) => name === "__wbg_studio_free")) return instantiate(module, imports);
    if (modules.calls.length > 0) {
      modules.isWaiting = true;
      await held;
    }
    const instance = await instantiate(module, imports);
    const place = modules.calls.push(0) - 1;
    const counted = (call) => (...values) => {
      modules.calls[place] += 1;
      return call(...values);
    };
    const exports = Object.entries(instance.exports).map(([name, value]) => [name, typeof value === "function" ? counted(value) : value]);
    return { module, instance: { exports: Object.fromEntries(exports) } };
  };
}
