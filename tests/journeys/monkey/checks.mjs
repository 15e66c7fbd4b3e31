import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { setTimeout } from "node:timers/promises";
import { validateGlb } from "../validate-glb.mjs";

/**
 * What must hold after any actions, as a visitor can check it.
 *
 * @typedef {import("./visit.mjs").Visit} Visit
 */

/** Work is kept within this time after the last change. */
const KEPT_MS = 1_000;
const DOWNLOAD_MS = 20_000;

/** @type {Record<string, (visit: Visit) => Promise<void>>} */
export const CHECKS = { "undo and redo": atRest(undoAndRedo), history: atRest(historyInFile), GLB: atRest(validGlb), reload: atRest(reloaded) };

/** Lets go of everything and waits for files, before a face is checked. @param {(visit: Visit) => Promise<void>} check */
function atRest(check) {
  return async (/** @type {Visit} */ visit) => {
    await visit.untilQuiet();
    await visit.page.evaluate(() => {
      for (const dialog of document.querySelectorAll("dialog[open]")) dialog.close();
      document.activeElement.blur();
    });
    const { state, busy } = await visit.look(2);
    if (state === "face" && !busy) await check(visit);
  };
}

/** Undo and then redo gives the same mesh and the same history. @param {Visit} visit */
async function undoAndRedo(visit) {
  const before = await work(visit);
  if (!(await visit.press("#section-history [data-action='undo']"))) return;
  await visit.look(2);
  assert.ok(await visit.press("#section-history [data-action='redo']"), "redo is not offered after undo");
  await visit.look(2);
  assertSame(before, await work(visit), "undo and redo");
}

/** The work is the same after a reload. @param {Visit} visit */
async function reloaded(visit) {
  const before = await work(visit);
  await setTimeout(KEPT_MS);
  await visit.page.reload();
  assert.ok(await visit.resume(10_000), "the work is not offered after a reload");
  assertSame(before, await work(visit), "a reload");
}

/** The project file holds as many edits as the page lists. @param {Visit} visit */
async function historyInFile(visit) {
  const file = await download(visit, "save-project", ".rosto");
  const header = JSON.parse(file.subarray(0, file.indexOf("\n")).toString());
  assert.equal(entriesIn(header)?.length, (await history(visit)).length, "the page and its project file hold different numbers of edits");
}

/** @param {Visit} visit */
async function validGlb(visit) {
  const verdict = await validateGlb(new Uint8Array(await download(visit, "download-glb", ".glb")));
  assert.ok(verdict.clean, `the GLB draws remarks ${verdict.counts}: ${verdict.messages.slice(0, 3).join("; ")}`);
}

/** The history, and the mesh in millimetres: a reload forgets what was chosen for files. @param {Visit} visit */
async function work(visit) {
  await visit.press("input[name='export-units'][value='mm']");
  return { history: await history(visit), mesh: await download(visit, "download-json", ".json") };
}

/** @param {Awaited<ReturnType<typeof work>>} before @param {Awaited<ReturnType<typeof work>>} after @param {string} cause */
function assertSame(before, after, cause) {
  assert.deepEqual(after.history, before.history, `${cause} changed the history`);
  if (before.mesh.equals(after.mesh)) return;
  const [from, to] = [before, after].map(({ mesh }) => JSON.parse(mesh.toString()).positions.flat());
  assert.equal(to.length, from.length, `${cause} changed the number of coordinates`);
  const furthest = Math.max(...from.map((value, at) => Math.abs(value - to[at])));
  assert.fail(`${cause} changed the mesh, its coordinates by up to ${furthest} mm`);
}

/** @param {Visit} visit @returns {Promise<string[]>} */
function history({ page }) {
  return page.evaluate(() => [...document.querySelectorAll("#history li")].map((item) => `${item.querySelector("input")?.checked ? "" : "off: "}${item.textContent.trim()}`));
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

/** The first list called `entries`, however deep. @returns {unknown[] | undefined} */
function entriesIn(value) {
  if (typeof value !== "object" || value === null) return undefined;
  return Array.isArray(value.entries) ? value.entries : Object.values(value).map(entriesIn).find(Boolean);
}
