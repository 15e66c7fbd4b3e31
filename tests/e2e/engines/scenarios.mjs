import assert from "node:assert/strict";
import path from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { colourCount, difference } from "../pixels.mjs";
import { SAMPLE } from "../visitor.mjs";
import { checkGlb, download, shot, until } from "./steps.mjs";

/** @typedef {import("./browsers.mjs").Browser} Browser */

/** A drawn face in a format that only the browser decodes. */
const AVIF = path.resolve(import.meta.dirname, "../pictures/drawn-face.avif");
/** Time within which a change is saved. */
const SAVE_MS = 1_000;

/**
 * Core scenario for each engine: load, choose a photo, edit by number and by drag, undo, download, reload, resume, and
 * choose a photo that the browser decodes.
 *
 * @param {Browser} browser
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 * @returns {Promise<string>} the renderer's name
 */
export async function runCoreScenario(browser, url, pictures) {
  const picture = (name) => shot(browser, path.join(pictures, `${browser.name}-${name}.png`));
  /** Replaces a field's text and leaves the field. */
  const type = async (selector, text, leaving) => {
    await browser.click(selector);
    await browser.evaluate("document.activeElement.select()");
    await browser.type(text, leaving);
  };
  const untilEdits = (count) => until(browser, `document.querySelectorAll("#history .check").length === ${count}`, `${count} edits`);

  await browser.goto(url);
  await until(browser, `document.querySelector("#privacy-count[data-requests='0']")`, "the page with all its parts");
  await picture("arrived");
  await browser.chooseFile("#photo-file", SAMPLE);
  await untilFace(browser);
  await browser.click("#expert");
  const found = await picture("found");
  assert.ok(colourCount(found) > 40, "the face has no colours");
  const drawnBy = await renderer(browser);

  const selectBy = async (mode) => {
    await browser.click("#tab-shape");
    await browser.click(`label:has(input[name='selection'][value='${mode}'])`);
  };
  await selectBy("landmark");
  await type("#landmark-search", "nose tip", "Enter");
  await type("#landmark-offset [data-axis='y'] .number-field", "9", "Tab");
  await untilEdits(1);
  assert.ok(difference(found, await picture("by-number")) > 0.001, "the number did not change the picture");
  const lifted = await mesh(browser);

  await selectBy("region");
  const held = await picture("held");
  await browser.drag("#viewport", { x: 40, y: -30 });
  await untilEdits(2);
  assert.ok(difference(held, await picture("by-hand")) > 0.001, "the drag did not change the picture");
  assert.notDeepEqual((await mesh(browser)).positions, lifted.positions);

  await browser.click("#toolbar [data-action='undo']");
  await untilEdits(1);
  assert.deepEqual(await mesh(browser), lifted);
  await checkGlb(await download(browser, "#save-main"));
  await picture("downloaded");

  await sleep(SAVE_MS);
  await browser.reload();
  await until(browser, `document.querySelector("#continue").checkVisibility()`, "the offer to resume");
  await browser.click("#continue");
  await untilFace(browser);
  await untilEdits(1);
  await picture("again");
  assert.deepEqual(await mesh(browser), lifted);

  await browser.chooseFile("#photo-file", AVIF);
  await untilEdits(0);
  await picture("decoded");
  assert.deepEqual(await browser.errors(), []);
  return drawnBy;
}

/**
 * Scenario for the element on its example page: the face loads, a drag and a slider reshape it, and its GLB is valid.
 *
 * @param {Browser} browser
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 */
export async function runElementScenario(browser, url, pictures) {
  const picture = (what) => shot(browser, path.join(pictures, `${browser.name}-element-${what}.png`));
  const untilEdits = (count) => until(browser, `document.querySelector("rosto-studio").state.edits === ${count}`, `${count} edits`);

  await browser.goto(url);
  await until(browser, `document.querySelector("rosto-studio")?.state?.faces === 1`, "the element's face");
  const found = await picture("found");
  await browser.drag("rosto-studio", { x: 30, y: 20 });
  await untilEdits(1);
  await browser.click("#wider");
  await untilEdits(2);
  assert.ok(difference(found, await picture("edited")) > 0.001, "the edits do not show");

  const glb = await browser.evaluate(async () => {
    const bytes = new Uint8Array(await (await document.querySelector("rosto-studio").getGlb()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  await checkGlb(Buffer.from(glb, "base64"));
  assert.deepEqual(await browser.errors(), []);
}

/** Name of the WebGL2 renderer. @param {Browser} browser @returns {Promise<string>} */
async function renderer(browser) {
  const name = await browser.evaluate(() => {
    const gl = document.querySelector("#viewport").getContext("webgl2");
    const unmasked = gl?.getExtension("WEBGL_debug_renderer_info");
    return gl?.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  });
  assert.ok(name, "the page does not draw in WebGL2");
  return name;
}

/** @param {Browser} browser */
async function mesh(browser) {
  await browser.click("#tab-export");
  return JSON.parse((await download(browser, "#panel [data-action='download-json']")).toString());
}

/** @param {Browser} browser */
function untilFace(browser) {
  return until(browser, `document.querySelector("body[data-state='face']:not([data-texture]):has(#progress[hidden])")`, "a face");
}
