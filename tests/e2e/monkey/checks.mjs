import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { setTimeout } from "node:timers/promises";
import { validateGlb } from "../validate-glb.mjs";

/** @typedef {import("./visit.mjs").Visit} Visit */

/** Time within which a change is saved. */
const SAVE_MS = 1_000;
/** A file of the densest mesh waits for the measures of its print. */
const DOWNLOAD_MS = 90_000;

/** Properties that hold after any actions. @type {Record<string, (visit: Visit) => Promise<void>>} */
const CHECKS = { "undo and redo": undoAndRedo, history: historyInFile, GLB: validGlb, reload: reloaded };

/**
 * Closes dialogs and waits for files, then runs a check if a face is open.
 *
 * @param {Visit} visit
 * @param {string} what
 */
export async function check(visit, what) {
  await visit.untilQuiet();
  await visit.page.evaluate(() => {
    for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
    document.activeElement.blur();
  });
  const { state, busy } = await visit.look(2);
  if (state === "face" && !busy) await CHECKS[what](visit);
}

/** Undo followed by redo restores mesh and history. @param {Visit} visit */
async function undoAndRedo(visit) {
  const before = await work(visit);
  if (!(await visit.press("#section-history [data-action='undo']"))) return;
  await visit.look(2);
  assert.ok(await visit.press("#section-history [data-action='redo']"), "redo is disabled after undo");
  await visit.look(2);
  await expectSame(visit, before, "undo and redo");
}

/** A reload restores the work. @param {Visit} visit */
async function reloaded(visit) {
  const before = await work(visit);
  await setTimeout(SAVE_MS);
  await visit.page.reload();
  assert.ok(await visit.resume(10_000), "the work is not offered after a reload");
  await expectSame(visit, before, "a reload");
}

/** The project file contains as many edits as the page lists. @param {Visit} visit */
async function historyInFile(visit) {
  const file = await download(visit, "save-project", ".rosto");
  const saved = JSON.parse(file.subarray(0, file.indexOf("\n")).toString()).history;
  assert.equal(saved?.entries.length ?? 0, (await history(visit)).length, "the page and the project file differ in the number of edits");
}

/** @param {Visit} visit */
async function validGlb(visit) {
  const { messages } = await validateGlb(await download(visit, "download-glb", ".glb"));
  assert.deepEqual(messages, []);
}

/** History, and the mesh in millimetres, because a reload resets the file options. @param {Visit} visit */
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

/** Each edit and its checkbox. @param {Visit} visit */
function history({ page }) {
  return page.locator("#history .check").evaluateAll((items) => items.map((item) => [item.textContent, item.querySelector("input")?.checked]));
}

/** @param {Visit} visit @param {string} action @param {string} extension */
async function download(visit, action, extension) {
  const button = `#panel [data-action="${action}"]`;
  // Ignores a picture download that is still pending.
  const isOfThisKind = (file) => file.suggestedFilename().endsWith(extension);
  const [file] = await Promise.all([
    visit.page.waitForEvent("download", { predicate: isOfThisKind, timeout: DOWNLOAD_MS }),
    visit.press(button).then((isPressed) => assert.ok(isPressed, `${action} is disabled or absent`)),
  ]);
  return readFile(await file.path());
}
