import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { storedWorks, untilSaved } from "./storage.mjs";
import { meanStep } from "./pixels.mjs";
import { corruptMemory, hookModule, trapIn } from "./page-scripts.mjs";

test.use({ visit: { expert: true, scripts: [hookModule] } });

for (const { drawn, needs } of [
  { drawn: "WebGPU", needs: "eyes" },
  { drawn: "WebGL2", needs: "webgl" },
]) {
  test(`a module with corrupted memory restarts twice under ${drawn} and restores work, choices and view`, { tag: `@${needs}` }, async ({ editor, page }) => {
    await editor.untilLoaded();
    const start = await workOn(editor);
    const work = await editor.meshJson("mm");
    const choices = await readChoices(editor);
    await page.mouse.move(4, 4);
    const view = await editor.view();

    await page.evaluate(corruptMemory);
    const box = await page.locator("#viewport").boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.move(box.x + box.width / 2 + 30, box.y + box.height / 2 + 8, { steps: 3 });
    await untilRestarted(editor);
    assert.match((await editor.notice()).text, /restarted\s+Your work is back as it was/);
    await expectRestored(editor, { work, choices, view });

    for (let again = 0; again < 2; again++) {
      // Clicks, because Escape would also cancel an edit and save the work, and so enter the module before the key
      // below.
      await page.click("#notice-close");
      await page.waitForSelector("#notice", { state: "hidden" });
      await page.evaluate(corruptMemory);
      await page.focus("#viewport");
      // Turns the camera.
      await page.keyboard.press("ArrowLeft");
      await untilRestarted(editor);
      await expectRestored(editor, { work, choices, view });
    }
    for (const [action, mesh] of /** @type {const} */ ([["undo", start], ["redo", work]])) {
      for (let step = 0; step < 2; step++) await page.click(`#toolbar [data-action='${action}']`);
      assert.deepEqual(await editor.meshJson("mm"), mesh);
    }
    assert.equal(await page.getAttribute("#privacy-count", "data-requests"), "0");
  });
}

test("a panic during export or opening restarts the module, and the next attempt works", async ({ editor, page }) => {
  await editor.untilLoaded();
  await workOn(editor);
  const work = await editor.meshJson("mm");
  const project = await editor.download("save-project");

  await page.evaluate(trapIn, "studio_savedEdits");
  await editor.reveal("#export-units");
  await page.click("#section-export [data-action='download-json']");
  await untilRestarted(editor);
  assert.deepEqual(await editor.meshJson("mm"), work);
  await editor.untilFace();
  const texture = await editor.download("download-png");
  assert.equal(texture.readUInt32BE(16), 1024, "the texture of the whole face was not restored");

  await page.keyboard.press("Escape");
  await page.evaluate(trapIn, "studio_open");
  await editor.drop(project, "face.rosto");
  await untilRestarted(editor);
  assert.deepEqual(await editor.meshJson("mm"), work);
  await editor.drop(project, "face.rosto");
  await page.waitForSelector("#notice", { state: "hidden" });
  await editor.untilFace();
  assert.deepEqual(await editor.meshJson("mm"), work);
  await page.click("#toolbar [data-action='undo']");
  assert.notDeepEqual(await editor.meshJson("mm"), work);
});

test("a face opened during a restart leaves the saved work unchanged", async ({ editor, page }) => {
  await editor.untilLoaded();
  const other = await editor.download("save-project");
  await workOn(editor);
  await untilSaved(page);
  const histories = async () => (await storedWorks(page)).map(({ edits }) => edits).filter((edits) => edits.includes("nose-tip"));
  const kept = await histories();
  assert.equal(kept.length, 1);

  await page.evaluate(corruptMemory);
  // In one task, so that the file arrives before the restart has finished.
  await page.evaluate((bytes) => {
    const options = { bubbles: true, cancelable: true };
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], "other.rosto"));
    document.getElementById("viewport").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft", ...options }));
    document.getElementById("stage").dispatchEvent(new DragEvent("drop", { dataTransfer, ...options }));
  }, new Uint8Array(other));
  await untilRestarted(editor);
  await editor.drop(other, "other.rosto");
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 0);
  await untilSaved(page);
  assert.deepEqual(await histories(), kept);
});

/** Makes two edits on a finer mesh with other choices and another view; returns the mesh before them. */
async function workOn(visitor) {
  const { page } = visitor;
  await visitor.choosePreset("paper");
  await visitor.unfold("light");
  await page.selectOption("#density", "1");
  await page.check("input[name='shading'][value='colours']", { force: true });
  await page.locator("#light-lamp .number-field").first().fill("80");
  const start = await visitor.meshJson("mm");
  await visitor.move("nose tip", "z", 9);
  await visitor.setSlider("nose-width", 4);
  // Clears the selection, which a restart does not restore.
  const { x, y } = await visitor.emptyPoint();
  await page.mouse.click(x, y);
  return start;
}

/** Current choices and history. */
async function readChoices(visitor) {
  const { page } = visitor;
  return {
    density: await page.inputValue("#density"),
    paint: await page.isChecked("input[name='shading'][value='colours']"),
    preset: await page.isChecked("input[name='preset'][value='paper']"),
    history: await visitor.history(),
  };
}

async function expectRestored(visitor, { work, choices, view }) {
  assert.deepEqual(await readChoices(visitor), choices);
  assert.deepEqual(await visitor.meshJson("mm"), work);
  // Moves the pointer away, because the face shows its landmarks near it.
  await visitor.page.mouse.move(4, 4);
  // The camera frames the face as newly opened, at a slightly different distance.
  const look = await visitor.view();
  for (const left of [0.42, 0.48, 0.54]) {
    const step = meanStep(view, look, { left, top: 0.4, right: left + 0.05, bottom: 0.5 });
    assert.ok(step < 8, `colours are ${step} levels off at ${left} of the width`);
  }
}

async function untilRestarted(visitor) {
  await visitor.page.waitForSelector("#notice[data-code='restarted']");
  await visitor.frames(3);
}
