import assert from "node:assert/strict";
import { changedProject, glbOf, partsOfGlb, projectWithoutShape } from "./changed-files.mjs";
import { test } from "./fixtures.mjs";

/** @type {Record<string, (history: any) => void>} */
const BAD_HISTORIES = {
  "an offset that is no number": (history) => (history.entries[0].move.offsets[0][2] = null),
  "an offset of 10³⁰ m": (history) => (history.entries[0].move.offsets[0][2] = 1e30),
  "a level that no mesh has": (history) => (history.entries[0].move.level = 5),
  "a point that is not there": (history) => (history.entries[0].move.handles = [9999]),
};

/** @type {{ name: string, codes: string[], change: (header: any) => void }[]} */
const BAD_HEADERS = [
  { name: "a history of another version", codes: ["other-version"], change: ({ edits }) => (edits.version = 99) },
  { name: "a project of another version", codes: ["other-version"], change: (header) => (header.version = 99) },
  { name: "no edits", codes: ["bad-project", "bad-history"], change: (header) => delete header.edits },
  { name: "a width of 0", codes: ["bad-project", "bad-face"], change: (header) => (header.width_px = 0) },
  ...Object.entries(BAD_HISTORIES).map(([name, change]) => ({
    name,
    codes: ["bad-project", "bad-history"],
    change: ({ edits }) => change(edits),
  })),
];

test("a project that cannot be opened leaves the face, its history and what is kept of it", async ({ visitor }) => {
  const project = await workOn(visitor, "save-project");
  const bad = BAD_HEADERS.map(({ change, ...told }) => ({
    ...told,
    file: changedProject(project, (header) => {
      change(header);
      return header;
    }),
  }));
  bad.push({ name: "a face without a shape", codes: ["bad-face", "bad-project"], file: projectWithoutShape(project) });
  await expectRefused(visitor, bad, "face.rosto");
});

test("a GLB that cannot be opened leaves the face, its history and what is kept of it", { tag: "@rare" }, async ({ visitor }) => {
  const glb = await workOn(visitor, "download-glb");
  /** @param {(extras: any) => void} change */
  const changed = (change) => {
    const parts = partsOfGlb(glb);
    change(parts.json.scenes[0].extras);
    return glbOf(parts);
  };
  const bad = Object.entries(BAD_HISTORIES).map(([name, change]) => ({
    name,
    codes: ["damaged-glb", "bad-history"],
    file: changed(({ history }) => change(history)),
  }));
  bad.push(
    { name: "a GLB of another version", codes: ["other-version"], file: changed((extras) => (extras.version = 99)) },
    { name: "a history of another version", codes: ["other-version"], file: changed(({ history }) => (history.version = 99)) },
    { name: "a history that is none", codes: ["damaged-glb", "bad-history"], file: changed((extras) => (extras.history = {})) },
    { name: "a photo without width", codes: ["damaged-glb", "bad-face"], file: changed((extras) => (extras.photo_px = [0, 512])) },
  );
  await expectRefused(visitor, bad, "face.glb");
});

test("kept work whose picture is damaged gets a notice, and the page goes on", async ({ visitor, page }) => {
  await workOn(visitor, "save-project");
  await page.waitForFunction(faceIsKept);
  await page.reload();
  await page.waitForSelector("#continue:not([hidden])");
  for (const spoilt of /** @type {const} */ (["too short", "gone", "of another kind"])) {
    await page.evaluate(spoilPictures, spoilt);
    await page.click("#continue");
    const { code, text } = await visitor.notice();
    assert.equal(code, "bad-kept-work", spoilt);
    assert.match(text, /cannot be opened/);
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });
  }
  await visitor.openFace();
  const found = await visitor.meshJson("mm");
  await visitor.move("nose tip", "z", 5);
  assert.notDeepEqual(await visitor.meshJson("mm"), found);
});

/** A face with two edits, and its file. */
async function workOn(visitor, action) {
  await visitor.openFace();
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
  // What comes next is done to the same face, and is kept.
  await visitor.move("nose tip", "y", 3);
  const next = await visitor.meshJson("mm");
  assert.notDeepEqual(next, work);
  await page.reload();
  await visitor.resume();
  assert.deepEqual(await visitor.meshJson("mm"), next);
  await page.click("#toolbar [data-action='undo']");
  assert.deepEqual(await visitor.meshJson("mm"), work);
}

/** Runs in the page: whether the picture has reached the database. */
async function faceIsKept() {
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  const count = database.transaction("faces").objectStore("faces").count();
  const found = await new Promise((resolve) => (count.onsuccess = () => resolve(count.result)));
  database.close();
  return found > 0;
}

/** Runs in the page: puts something else in the place of every picture that is kept. */
async function spoilPictures(spoilt) {
  const picture = { "too short": new Blob([new Uint8Array(7)]), gone: undefined, "of another kind": "a picture" }[spoilt];
  const database = await new Promise((resolve) => (indexedDB.open("rosto").onsuccess = ({ target }) => resolve(target.result)));
  const transaction = database.transaction("faces", "readwrite");
  const store = transaction.objectStore("faces");
  store.openCursor().onsuccess = ({ target }) => {
    if (!target.result) return;
    target.result.update({ ...target.result.value, picture });
    target.result.continue();
  };
  await new Promise((resolve) => (transaction.oncomplete = resolve));
  database.close();
}
