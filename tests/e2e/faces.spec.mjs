import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { findings } from "./boxes.mjs";
import { test } from "./fixtures.mjs";
import { chooseFace, openGroup, PREVIOUS_FACE } from "./groups.mjs";
import { storedWorks, untilSaved } from "./storage.mjs";
import { asJpeg, sixTimes } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";
import { hookModule, trapIn, refuseDatabase } from "./page-scripts.mjs";

test.use({ visit: { expert: true } });

test("each face of a group keeps its edits and name when you switch between them, and the tab stays", async ({ visitor, page }) => {
  await openGroup(visitor);
  assert.equal(await page.getAttribute("#face-choice", "aria-label"), "2 faces in this photo");
  assert.equal((await visitor.save("download-glb")).name, "group.glb");
  const nose = async () => (await visitor.meshJson("image")).positions[1][0];
  const firstNose = await nose();
  await visitor.move("nose tip", "z", 9);
  await visitor.move("nose tip", "z", -2);
  await visitor.unfold("section-view");
  await page.selectOption("#density", "1");
  const first = await visitor.work();

  await visitor.unfold("section-view");
  await choose(visitor, 1);
  assert.equal(await page.getAttribute("body", "data-tab"), "view");
  assert.equal((await visitor.save("download-glb")).name, "group-2-1833.glb");
  assert.deepEqual(await visitor.history(), []);
  const apart = Math.abs((await nose()) - firstNose);
  assert.ok(Math.abs(apart - 0.5) < 0.01, `the two noses are ${apart} of the width apart`);
  await visitor.setSlider("jaw-width", 4);
  const second = await visitor.work();
  assert.notDeepEqual(second.mesh, first.mesh);
  await visitor.unfold("section-view");
  await page.check("#view-wireframe");

  await choose(visitor, 0);
  assert.deepEqual(await visitor.work(), first);
  assert.ok(await page.isChecked("#view-wireframe"), "the view settings changed with the face");
  await page.click("#toolbar [data-action='undo']");
  assert.notDeepEqual((await visitor.work()).mesh, first.mesh);
  await page.click("#toolbar [data-action='redo']");

  await choose(visitor, 1);
  assert.deepEqual(await visitor.work(), second);
  // Each face has one slot; the tab holds the lock of one.
  await untilSaved(page);
  const kept = await storedWorks(page);
  assert.deepEqual(kept.map(({ name, isLocked }) => [name, isLocked]).sort(), [["group", false], ["group-2", true]]);
  assert.match(kept.find(({ name }) => name === "group").edits, /nose-tip/);
});

test("after switching faces, a reload offers the last shown face with its work", async ({ visitor, page }) => {
  await openGroup(visitor);
  await visitor.move("nose tip", "z", 9);
  for (const index of [1, 0, 1, 0]) await choose(visitor, index);
  await visitor.move("nose tip", "z", 3);
  const first = await visitor.work();
  await untilSaved(page, 2);
  assert.equal((await storedWorks(page)).length, 2);
  await visitor.reloadAndResume();
  assert.deepEqual(await visitor.work(), first);
});

test("the previous face is one click away with its edits, in both directions", async ({ editor, page }) => {
  assert.ok(await page.isHidden("#faces"), "there is a previous face");
  await editor.move("nose tip", "z", 9);
  const photo = await editor.work();
  const project = await editor.download("save-project");
  const glb = await editor.download("download-glb");

  // Each kind of file that replaces a face can be reverted: project, GLB and photo.
  const others = [
    { bytes: project, name: "other.rosto" },
    { bytes: glb, name: "other.glb" },
    { bytes: await asJpeg(page, await readFile(SAMPLE), { width: 640, height: 480 }), name: "other.jpg" },
  ];
  for (const { bytes, name } of others) {
    await editor.drop(bytes, name);
    await untilNamed(editor, "other");
    await editor.setSlider("jaw-width", 4);
    const other = await editor.work();
    await goBack(editor, "portrait");
    assert.deepEqual(await editor.work(), photo, name);
    await goBack(editor, "other");
    assert.deepEqual(await editor.work(), other, name);
    await goBack(editor, "portrait");
  }
  assert.ok(await page.isHidden("#face-choice"));
});

test("earlier photos are offered by name, with their edits", async ({ visitor, page }) => {
  const left = new Map();
  for (const [place, name] of ["ana", "bia", "clara", "dora", "eva"].entries()) {
    await visitor.openFace(name);
    await untilNamed(visitor, name);
    await visitor.move("nose tip", "z", place + 2);
    left.set(name, await visitor.work());
  }
  const offered = () => page.locator("#earlier-options button").evaluateAll((buttons) => buttons.map((button) => button.title));
  assert.deepEqual(await offered(), ["dora", "clara", "bia", "ana"].map((name) => `Back to ${name}`));
  await page.click("#earlier-options button[title='Back to bia']");
  await untilNamed(visitor, "bia");
  assert.deepEqual(await visitor.work(), left.get("bia"));
  assert.deepEqual(await offered(), ["eva", "dora", "clara", "ana"].map((name) => `Back to ${name}`));
  await goBack(visitor, "eva");
  assert.deepEqual(await visitor.work(), left.get("eva"));
});

for (const [keeps, scripts] of /** @type {const} */ ([["everything", []], ["nothing", [refuseDatabase]]])) {
  test(`returning to a group restores each face; the browser stores ${keeps}`, async ({ open }) => {
    const visitor = await open({ scripts: [...scripts] });
    const { page } = visitor;
    await openGroup(visitor);
    if (keeps === "nothing") await page.waitForSelector("#notice[data-code='not-kept']");
    await visitor.move("nose tip", "z", 9);
    const first = await visitor.work();
    await choose(visitor, 1);
    await visitor.setSlider("jaw-width", 4);
    const second = await visitor.work();

    await visitor.openFace("alone");
    await untilNamed(visitor, "alone");
    assert.ok(await page.isHidden("#face-choice"));
    await goBack(visitor, "group-2");
    assert.ok(await page.isVisible("#face-choice"));
    assert.deepEqual(await chosen(page), [false, true]);
    assert.deepEqual(await visitor.work(), second);
    await choose(visitor, 0);
    assert.deepEqual(await visitor.work(), first);
  });
}

test("the last of several quickly chosen faces is shown, and a restart of the module changes nothing", async ({ open }) => {
  const visitor = await open({ scripts: [hookModule] });
  const { page } = visitor;
  await visitor.untilLoaded();
  await openGroup(visitor);
  await visitor.move("nose tip", "z", 9);
  const first = await visitor.work();
  // In one task, faster than a face can open.
  await page.evaluate(() => {
    const [one, other] = document.querySelectorAll("#face-options input");
    for (const input of [other, one, other, one]) input.click();
  });
  await visitor.frames(20);
  assert.deepEqual(await chosen(page), [true, false]);
  assert.deepEqual(await visitor.work(), first);
  // A file without a face replaces nothing.
  await visitor.drop(Buffer.from("no picture"), "broken.jpg");
  await page.waitForSelector("#notice[data-code='not-a-picture']");
  assert.deepEqual(await chosen(page), [true, false]);
  assert.deepEqual(await visitor.work(), first);

  await choose(visitor, 1);
  await page.evaluate(trapIn, "studio_savedEdits");
  await visitor.unfold("section-export");
  await page.click("[data-action='download-json']");
  await page.waitForSelector("#notice[data-code='restarted']");
  await choose(visitor, 0);
  assert.deepEqual(await visitor.work(), first);
});

test("on a phone a row of faces scrolls by wheel and keys, its cut ends fade, and the chosen face is visible", async ({ open }) => {
  const visitor = await open({ viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.drop(await sixTimes(page, await readFile(SAMPLE)), "group.png");
  await page.waitForSelector("#face-choice:not([hidden])");
  await visitor.untilFace();
  const strip = await page.locator("#faces").boundingBox();
  assert.ok(strip.x >= 0 && strip.x + strip.width <= 360, JSON.stringify(strip));
  const [options, last] = [page.locator("#face-options"), page.locator("#face-options canvas").nth(5)];
  const isCut = (ends) => expect(options).toHaveAttribute("data-cut", ends);
  assert.ok(await page.isVisible("#earlier-faces"), "the earlier photo is not offered");
  await isCut("end");
  await options.hover();
  await page.mouse.wheel(0, 20);
  await isCut("start end");
  await page.mouse.wheel(0, 400);
  await isCut("start");
  await page.mouse.wheel(0, -400);
  await isCut("end");
  const rightOf = async (locator) => (({ x, width }) => x + width)(await locator.boundingBox());
  assert.ok((await rightOf(last)) > (await rightOf(options)) + 1, "the row does not overflow");
  await page.locator("#face-options input").nth(5).focus();
  await page.locator("#face-options input").nth(5).press("Space");
  await untilNamed(visitor, "group-6");
  const { x, width } = await last.boundingBox();
  assert.ok(x > strip.x && x + width <= (await rightOf(options)), "the chosen face is out of sight");
  assert.equal(await page.evaluate("scrollX + document.getElementById('stage').scrollLeft"), 0);
});

for (const [width, height] of [[390, 844], [844, 390], [720, 450]]) {
  test(`at ${width}×${height} the faces of a group appear over the stage and cover no other element`, async ({ open }) => {
    const visitor = await open({ viewport: { width, height } });
    const { page } = visitor;
    await visitor.openFace();
    await openGroup(visitor);
    assert.ok(await page.isVisible(PREVIOUS_FACE));
    assert.deepEqual(await page.locator(".face-row > p").allInnerTexts(), ["In this photo", "Earlier photos"]);
    const strip = await page.locator("#faces").boundingBox();
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(strip.x >= stage.x && strip.x + strip.width <= stage.x + stage.width && strip.y >= stage.y, JSON.stringify({ strip, stage }));
    for (const input of await page.locator(".face-strip canvas").all()) {
      const { x, y, width: across } = await input.boundingBox();
      assert.ok(across >= 40, `a thumbnail of ${across} px`);
      assert.ok(x >= strip.x && x + across <= strip.x + strip.width && y >= strip.y, "a thumbnail is cut off");
    }
    await visitor.drop(Buffer.from("no picture"), "broken.jpg");
    await visitor.notice();
    assert.deepEqual(await findings(page), []);
  });
}

/** Chooses a face of the group by its index in the strip. */
async function choose(visitor, index) {
  await chooseFace(visitor, index);
  await untilNamed(visitor, index === 0 ? "group" : `group-${index + 1}`);
}

async function goBack(visitor, name) {
  await visitor.page.click(PREVIOUS_FACE);
  await untilNamed(visitor, name);
}

/** Waits until the face with this name is open, by the name of its files. */
async function untilNamed(visitor, name) {
  await expect(visitor.page.locator("#export-file dt")).toHaveText(new RegExp(`^${name}(-\\d{3,})?\\.glb$`));
  await visitor.untilFace();
}

function chosen(page) {
  return page.locator("#face-options input").evaluateAll((inputs) => inputs.map(({ checked }) => checked));
}
