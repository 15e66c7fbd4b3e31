import assert from "node:assert/strict";
import {
  changedProject, glbOf, lengthenHistory, partsOfGlb, projectWithoutShape, removeWidth, scatterLandmarks,
} from "./changed-files.mjs";
import { test } from "./fixtures.mjs";
import { changeStorage, untilSaved } from "./storage.mjs";

/** @typedef {[name: string, code: string, change: (json: any) => unknown][]} Changes with the code of the notice */

/** The session's tests have further histories. @type {Changes} */
const BAD_HEADERS = [
  ["a project of another version", "other-version", (header) => (header.version = 99)],
  ["no photos", "bad-project", (header) => delete header.photos],
  ["landmarks that are not a face", "not-a-face", scatterLandmarks],
  ["an offset of 10³⁰ m", "bad-history", ({ history }) => (history.entries[0].move.offsets[0][2] = 1e30)],
];

/** @type {Changes} */
const BAD_EXTRAS = [
  ["a GLB of another version", "other-version", (extras) => (extras.version = 99)],
  ["a history of another version", "other-version", ({ history }) => (history.version = 99)],
  ["an empty object as history", "bad-history", (extras) => (extras.history = {})],
  ["a photo without width", "damaged-glb", removeWidth],
  ["landmarks that are not a face", "not-a-face", scatterLandmarks],
  ["100 000 edits", "too-many-edits", (extras) => lengthenHistory(extras, 100_000)],
  ["a vertex that does not exist", "bad-history", ({ history }) => (history.entries[0].move.handles = [9999])],
];

test("a project that cannot be opened leaves the face, its history and the saved work unchanged", async ({ editor }) => {
  const project = await editAndSave(editor, "save-project");
  const bad = BAD_HEADERS.map(([name, code, change]) => ({ name, code, file: changedProject(project, (header) => void change(header)) }));
  bad.push({ name: "a face without a shape", code: "not-a-face", file: projectWithoutShape(project) });
  await expectRefused(editor, bad, "face.rosto");
});

test("a GLB that cannot be opened leaves the face, its history and the saved work unchanged", async ({ editor }) => {
  const glb = await editAndSave(editor, "download-glb");
  const bad = BAD_EXTRAS.map(([name, code, change]) => {
    const parts = partsOfGlb(glb);
    change(parts.json.scenes[0].extras);
    return { name, code, file: glbOf(parts) };
  });
  const foreign = glbOf({ json: { asset: { version: "2.0" }, scenes: [{}] }, bytes: Buffer.alloc(0) });
  bad.push({ name: "a GLB of another program", code: "foreign-glb", file: foreign });
  bad.push({ name: "a truncated GLB", code: "damaged-glb", file: glb.subarray(0, glb.length / 2) });
  await expectRefused(editor, bad, "face.glb");
});

test("saved work with a damaged file shows a notice, and the page stays usable", async ({ editor, page }) => {
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
 * @param {{ name: string, code: string, file: Buffer }[]} bad
 * @param {string} fileName
 */
async function expectRefused(visitor, bad, fileName) {
  const { page } = visitor;
  const work = await visitor.meshJson("mm");
  const history = await visitor.history();
  for (const { name, code, file } of bad) {
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });
    await visitor.drop(file, fileName);
    assert.equal((await visitor.notice()).code, code, name);
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
