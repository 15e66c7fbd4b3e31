import { readFile } from "node:fs/promises";
import { validateGlb } from "../validate-glb.mjs";

/**
 * What must hold whatever was done before, as a visitor can check it. Each check gives what is wrong, or nothing.
 *
 * @typedef {import("./hands.mjs").Hands} Hands
 */

/** Work is kept within this time after the last change. */
const KEPT_MS = 1_000;
const DOWNLOAD_MS = 20_000;

/** What the files are called that the page offers. */
const ENDINGS = { "save-project": ".rosto", "download-glb": ".glb", "download-json": ".json" };

/** @type {Record<"undo-redo" | "history" | "glb" | "reload", (hands: Hands) => Promise<string | undefined>>} */
const CHECKS = { "undo-redo": undoAndRedo, history: historyInFile, glb: validGlb, reload: reloaded };

/**
 * @param {Hands} hands
 * @param {keyof typeof CHECKS} what
 * @returns {Promise<string | undefined>} what is wrong
 */
export async function check(hands, what) {
  if (!(await comeToRest(hands))) return undefined;
  return CHECKS[what](hands);
}

/**
 * Lets go of whatever is in hand and waits for files, if a face is there to be checked.
 *
 * @param {Hands} hands
 */
async function comeToRest({ page }) {
  await page.waitForFunction(() => !window["__eyes"].look().busy, undefined, { timeout: DOWNLOAD_MS }).catch(() => {});
  const seen = await page.evaluate(() => {
    for (const dialog of document.querySelectorAll("dialog[open]")) /** @type {HTMLDialogElement} */ (dialog).close();
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    return window["__eyes"].settle(2);
  });
  return seen.state === "face" && !seen.busy;
}

/** Undo and then redo gives the same mesh and the same history. @param {Hands} hands */
async function undoAndRedo(hands) {
  const before = await mesh(hands);
  const listed = await history(hands);
  if (!(await act(hands, "undo"))) return undefined;
  if (!(await act(hands, "redo"))) return "redo is not offered after undo";
  const after = await mesh(hands);
  if (!before.equals(after)) return `undo and redo changed the mesh: ${difference(before, after)}`;
  const now = await history(hands);
  return listed.join("; ") === now.join("; ") ? undefined : `undo and redo changed the history from [${listed}] to [${now}]`;
}

/** The project file holds as many edits as the page lists. @param {Hands} hands */
async function historyInFile(hands) {
  const file = await download(hands, "save-project");
  const header = JSON.parse(file.subarray(0, file.indexOf("\n")).toString());
  const saved = entriesIn(header)?.length;
  const listed = (await history(hands)).length;
  return saved === listed ? undefined : `the page lists ${listed} edits, its file holds ${saved}`;
}

/** @param {Hands} hands */
async function validGlb(hands) {
  const { clean, counts, messages } = await validateGlb(new Uint8Array(await download(hands, "download-glb")));
  return clean ? undefined : `the GLB draws remarks ${counts}: ${messages.slice(0, 3).join("; ")}`;
}

/** The work is the same after a reload. @param {Hands} hands */
async function reloaded(hands) {
  const before = await mesh(hands);
  const listed = await history(hands);
  await hands.page.waitForTimeout(KEPT_MS);
  await hands.page.reload();
  if (!(await hands.goOn(10_000))) return "the work is not offered after a reload";
  const after = await mesh(hands);
  if (!before.equals(after)) return `a reload changed the mesh: ${difference(before, after)}`;
  const now = await history(hands);
  return listed.length === now.length ? undefined : `a reload changed the history from [${listed}] to [${now}]`;
}

/** @param {Hands} hands @param {"undo" | "redo"} action @returns {Promise<boolean>} whether it could be done */
function act({ page }, action) {
  return page.evaluate(async (action) => {
    const button = /** @type {HTMLButtonElement | null} */ (document.querySelector(`#section-history [data-action="${action}"]`));
    if (!button || button.disabled) return false;
    button.click();
    await window["__eyes"].settle(2);
    return true;
  }, action);
}

/** @param {Hands} hands @returns {Promise<string[]>} */
function history({ page }) {
  return page.evaluate(() => [...document.querySelectorAll("#history li")].map((item) => `${item.querySelector("input")?.checked ? "" : "off: "}${item.textContent?.trim()}`));
}

/** The mesh in millimetres: a reload forgets what was chosen for files. @param {Hands} hands */
async function mesh(hands) {
  await hands.page.evaluate(() => window["__eyes"].press("input[name='export-units'][value='mm']"));
  return download(hands, "download-json");
}

/** @param {Hands} hands @param {string} action */
async function download({ page }, action) {
  const [file] = await Promise.all([
    // A picture that was asked for before may come in between.
    page.waitForEvent("download", { predicate: (file) => file.suggestedFilename().endsWith(ENDINGS[action]), timeout: DOWNLOAD_MS }),
    page.evaluate((action) => window["__eyes"].press(`#panel [data-action="${action}"]`), action),
  ]);
  return readFile(await file.path());
}

/** The first list called `entries`, however deep. @returns {unknown[] | undefined} */
function entriesIn(value) {
  if (typeof value !== "object" || value === null) return undefined;
  if (Array.isArray(value.entries)) return value.entries;
  for (const part of Object.values(value)) {
    const found = entriesIn(part);
    if (found) return found;
  }
  return undefined;
}

/** @param {Buffer} one @param {Buffer} other two meshes as JSON */
function difference(one, other) {
  const [before, after] = [one, other].map((bytes) => JSON.parse(bytes.toString()));
  if (before.positions.length !== after.positions.length) return `${before.positions.length} vertices, then ${after.positions.length}`;
  const apart = before.positions.map((place, vertex) => Math.hypot(...place.map((along, axis) => along - after.positions[vertex][axis])));
  const furthest = Math.max(...apart);
  if (furthest === 0) return "its places are the same, the rest is not";
  return `${apart.filter((far) => far > 0).length} of ${apart.length} vertices moved, by up to ${furthest} ${before.units}`;
}
