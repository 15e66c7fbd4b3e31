import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { setTimeout } from "node:timers/promises";
import { validateGlb } from "../validate-glb.mjs";

/** @typedef {import("./visit.mjs").Visit} Visit */

/** Work is kept within this time after the last change. */
const KEPT_MS = 1_000;
const DOWNLOAD_MS = 20_000;

/** What must hold after any actions, as a visitor can check it. @type {Record<string, (visit: Visit) => Promise<void>>} */
const CHECKS = { "undo and redo": undoAndRedo, history: historyInFile, GLB: validGlb, reload: reloaded };

/** Lets go of everything and waits for files, before a face is checked. @param {Visit} visit @param {string} what */
export async function check(visit, what) {
  await visit.untilQuiet();
  await visit.page.evaluate(() => {
    for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
    document.activeElement.blur();
  });
  const { state, busy } = await visit.look(2);
  if (state === "face" && !busy) await CHECKS[what](visit);
}

/** Undo and then redo gives the same mesh and the same history. @param {Visit} visit */
async function undoAndRedo(visit) {
  const before = await work(visit);
  if (!(await visit.press("#section-history [data-action='undo']"))) return;
  await visit.look(2);
  assert.ok(await visit.press("#section-history [data-action='redo']"), "redo is not offered after undo");
  await visit.look(2);
  await expectSame(visit, before, "undo and redo");
}

/** The work is the same after a reload. @param {Visit} visit */
async function reloaded(visit) {
  const before = await work(visit);
  await setTimeout(KEPT_MS);
  await visit.page.reload();
  assert.ok(await visit.resume(10_000), "the work is not offered after a reload");
  await expectSame(visit, before, "a reload");
}

/** The project file holds as many edits as the page lists. @param {Visit} visit */
async function historyInFile(visit) {
  const file = await download(visit, "save-project", ".rosto");
  const { edits } = JSON.parse(file.subarray(0, file.indexOf("\n")).toString());
  assert.equal(edits.entries.length, (await history(visit)).length, "the page and its project file hold different numbers of edits");
}

/** @param {Visit} visit */
async function validGlb(visit) {
  const { messages } = await validateGlb(await download(visit, "download-glb", ".glb"));
  assert.deepEqual(messages, []);
}

/** The history, and the mesh in millimetres: a reload forgets what was chosen for files. @param {Visit} visit */
async function work(visit) {
  if (!(await visit.page.isChecked("#expert"))) await visit.press("#expert");
  await visit.press("input[name='export-units'][value='mm']");
  return { history: await history(visit), mesh: await download(visit, "download-json", ".json") };
}

/** @param {Visit} visit @param {Awaited<ReturnType<typeof work>>} before @param {string} cause */
async function expectSame(visit, before, cause) {
  const after = await work(visit);
  assert.deepEqual(after.history, before.history, `${cause} changed the history`);
  assert.ok(after.mesh.equals(before.mesh), `${cause} changed the mesh`);
}

/** Each edit, and whether it is on. @param {Visit} visit */
function history({ page }) {
  return page.locator("#history li").evaluateAll((items) => items.map((item) => [item.textContent, item.querySelector("input")?.checked]));
}

/** @param {Visit} visit @param {string} action @param {string} extension */
async function download(visit, action, extension) {
  const [file] = await Promise.all([
    // A picture that was asked for before may come in between.
    visit.page.waitForEvent("download", { predicate: (file) => file.suggestedFilename().endsWith(extension), timeout: DOWNLOAD_MS }),
    visit.press(`#panel [data-action="${action}"]`),
  ]);
  return readFile(await file.path());
}
