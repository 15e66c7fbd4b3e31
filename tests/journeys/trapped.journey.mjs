import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { untilKept } from "./kept.mjs";
import { panicIn } from "./watches.mjs";

test("nothing is asked of a module that has trapped, whatever is pressed before and after another one is there", async ({ open }) => {
  const visitor = await open({ scripts: [countCalls] });
  const { page } = visitor;
  await visitor.untilLoaded();
  await visitor.openFace();
  await visitor.move("nose tip", "z", 9);
  await page.click("[data-tab-name='export']").catch(() => {});
  await visitor.meshJson("mm");
  const project = await visitor.download("save-project");
  await untilKept(page);

  await page.evaluate("modules.hold()");
  await page.evaluate(panicIn, { method: "orbit" });
  await page.focus("#viewport");
  await page.keyboard.press("ArrowLeft");
  await page.waitForFunction("modules.isWaiting");
  const calls = await page.evaluate("modules.calls[0]");
  assert.ok(calls > 100, `${calls} calls were counted`);
  await pressEverything(visitor);
  await visitor.drop(project, "face.rosto");
  await visitor.frames(5);
  assert.equal(await page.evaluate("modules.calls[0]"), calls, "the module that trapped was asked");

  await page.keyboard.press("Escape");
  await page.evaluate("modules.release()");
  await page.waitForSelector("#notice[data-code='restarted']");
  await visitor.untilFace();
  await pressEverything(visitor);
  // Objects of the module that trapped are collected by now.
  await page.requestGC?.();
  await visitor.frames(5);
  assert.equal(await page.evaluate("modules.calls[0]"), calls, "the module that trapped was asked later");
  visitor.checkNothingBroke();
});

/** Uses whatever is on the page and asks the studio something, and the pointer on the face. */
async function pressEverything({ page, frames }) {
  const box = await page.locator("#viewport").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y, { steps: 3 });
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 10, { steps: 3 });
  await page.mouse.up();
  await page.mouse.wheel(0, 40);
  await page.evaluate(() => {
    const inputs = [...document.querySelectorAll("#panel input, #panel select, #toolbar input")].filter(({ type }) => type !== "file");
    for (const input of inputs) for (const type of ["input", "change"]) input.dispatchEvent(new Event(type, { bubbles: true }));
    for (const details of document.querySelectorAll("#panel details")) details.open = !details.open;
    const isSafe = ({ id, dataset }) => !["photo-change", "add-photo", "clip"].includes(id) && dataset.action !== "choose" && dataset.action !== "sample";
    for (const button of [...document.querySelectorAll("#panel button, #toolbar button")].filter(isSafe)) button.click();
    for (const key of ["z", "ArrowUp", "Escape"]) {
      document.getElementById("viewport").dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey: key === "z", bubbles: true, cancelable: true }));
    }
  });
  await frames.call({ page }, 5);
}

/** Runs in the page before its scripts: counts the calls into each instance of the page's module, and can hold the next instance back. */
function countCalls() {
  const modules = { calls: [], isWaiting: false, release: () => {}, hold: () => {} };
  let held = Promise.resolve();
  // Returns undefined: `page.evaluate` awaits a returned promise.
  modules.hold = () => {
    held = new Promise((resolve) => (modules.release = resolve));
  };
  globalThis.modules = modules;
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (module, imports) => {
    const isStudio = module instanceof WebAssembly.Module && WebAssembly.Module.exports(module).some(({ name }) => name === "__wbg_studio_free");
    if (!isStudio) return instantiate(module, imports);
    if (modules.calls.length > 0) {
      modules.isWaiting = true;
      await held;
    }
    const instance = await instantiate(module, imports);
    const place = modules.calls.push(0) - 1;
    const counted = ([name, value]) => {
      if (typeof value !== "function") return [name, value];
      return [name, (...values) => {
        modules.calls[place] += 1;
        return value(...values);
      }];
    };
    return { module, instance: { exports: Object.fromEntries(Object.entries(instance.exports).map(counted)) } };
  };
}
