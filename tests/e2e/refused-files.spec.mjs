import assert from "node:assert/strict";
import {
  changedProject, glbOf, lengthenHistory, partsOfGlb, projectWithoutShape, removeWidth, scatterLandmarks,
} from "./changed-files.mjs";
import { test } from "./fixtures.mjs";
import { changeStorage, untilSaved } from "./storage.mjs";

/** @type {Record<string, (history: any) => void>} */
const BAD_HISTORIES = {
  "an offset that is not a number": (history) => (history.entries[0].move.offsets[0][2] = null),
  "an offset of 10³⁰ m": (history) => (history.entries[0].move.offsets[0][2] = 1e30),
  "a level that does not exist": (history) => (history.entries[0].move.level = 5),
  "a vertex that does not exist": (history) => (history.entries[0].move.handles = [9999]),
};

/** @typedef {[name: string, codes: string[], change: (json: any) => unknown][]} Changes codes: allowed notices */

/** @type {Changes} */
const BAD_HEADERS = [
  ["a history of another version", ["other-version"], ({ history }) => (history.version = 99)],
  ["a project of another version", ["other-version"], (header) => (header.version = 99)],
  ["no photos", ["bad-project"], (header) => delete header.photos],
  ["a width of 0", ["bad-project", "bad-face"], removeWidth],
  ["landmarks that are not a face", ["not-a-face"], scatterLandmarks],
  ["100 000 edits", ["too-many-edits"], (header) => lengthenHistory(header, 100_000)],
  ...Object.entries(BAD_HISTORIES).map(([name, change]) => [name, ["bad-project", "bad-history"], ({ history }) => change(history)]),
];

/** @type {Changes} */
const BAD_EXTRAS = [
  ["a GLB of another version", ["other-version"], (extras) => (extras.version = 99)],
  ["a history of another version", ["other-version"], ({ history }) => (history.version = 99)],
  ["an empty object as history", ["damaged-glb", "bad-history"], (extras) => (extras.history = {})],
  ["a photo without width", ["damaged-glb", "bad-face"], removeWidth],
  ["landmarks that are not a face", ["not-a-face"], scatterLandmarks],
  ["100 000 edits", ["too-many-edits"], (extras) => lengthenHistory(extras, 100_000)],
  ...Object.entries(BAD_HISTORIES).map(([name, change]) => [name, ["damaged-glb", "bad-history"], ({ history }) => change(history)]),
];

test("a project that cannot be opened leaves the face, its history and the saved work unchanged", async ({ editor }) => {
  const project = await editAndSave(editor, "save-project");
  const bad = BAD_HEADERS.map(([name, codes, change]) => ({ name, codes, file: changedProject(project, (header) => void change(header)) }));
  bad.push({ name: "a face without a shape", codes: ["not-a-face"], file: projectWithoutShape(project) });
  await expectRefused(editor, bad, "face.rosto");
});

test("a GLB that cannot be opened leaves the face, its history and the saved work unchanged", { tag: "@rare" }, async ({ editor }) => {
  const glb = await editAndSave(editor, "download-glb");
  const bad = BAD_EXTRAS.map(([name, codes, change]) => {
    const parts = partsOfGlb(glb);
    change(parts.json.scenes[0].extras);
    return { name, codes, file: glbOf(parts) };
  });
  await expectRefused(editor, bad, "face.glb");
});

test("saved work with a damaged file shows a notice, and the page stays usable", { tag: "@rare" }, async ({ editor, page }) => {
  await editAndSave(editor, "save-project");
  await untilSaved(page);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  for (const file of ["new Blob([new Uint8Array(7)])", "undefined", '"a file"']) {
    await changeStorage(page, `({ faces }) => (${replaceFile})(faces, ${file})`);
    await page.click("#continue");
    const { code, text } = await editor.notice();
    assert.equal(code, "bad-kept-work", file);
    assert.match(text, /can’t be opened/);
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });
  }
  await editor.openFace();
  const found = await editor.meshJson("mm");
  await editor.move("nose tip", "z", 5);
  assert.notDeepEqual(await editor.meshJson("mm"), found);
});

/** Makes two edits and saves the face with an action. */
async function editAndSave(visitor, action) {
  await visitor.move("nose tip", "z", 9);
  await visitor.move("bottom of the chin", "y", -6);
  return visitor.download(action);
}

/**
 * @param {import("./visitor.mjs").Visitor} visitor
 * @param {{ name: string, codes: string[], file: Buffer }[]} bad
 * @param {string} fileName
 */
async function expectRefused(visitor, bad, fileName) {
  const { page } = visitor;
  const work = await visitor.meshJson("mm");
  const history = await visitor.history();
  for (const { name, codes, file } of bad) {
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });
    await visitor.drop(file, fileName);
    const { code } = await visitor.notice();
    assert.ok(codes.includes(code), `${name}: ${code}`);
    await page.waitForSelector("#progress", { state: "hidden" });
    assert.deepEqual(await visitor.history(), history, name);
    assert.deepEqual(await visitor.meshJson("mm"), work, name);
  }
  // Editing continues and is saved.
  await visitor.move("nose tip", "y", 3);
  const next = await visitor.meshJson("mm");
  assert.notDeepEqual(next, work);
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.meshJson("mm"), next);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), work);
}

/** Runs in the page: replaces the saved files. */
function replaceFile(faces, file) {
  faces.openCursor().onsuccess = ({ target: { result } }) => {
    const files = result.value.files.map((source) => ({ ...source, file }));
    result.update({ ...result.value, files });
  };
}
