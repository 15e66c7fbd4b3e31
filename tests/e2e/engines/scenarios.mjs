import assert from "node:assert/strict";
import { readFile, readdir, rm } from "node:fs/promises";
import path from "node:path";
import { By, Key } from "selenium-webdriver";
import { colourCount, difference } from "../pixels.mjs";
import { SAMPLE } from "../visitor.mjs";
import { noteErrors } from "./browsers.mjs";
import { checkGlb, drag, shot, until, WAIT_MS } from "./steps.mjs";

/** @typedef {import("./browsers.mjs").Browser} Browser */

/** A drawn face in a format that only the browser decodes. */
const AVIF = path.resolve(import.meta.dirname, "../pictures/drawn-face.avif");
/** Time within which a change is saved. */
const SAVE_MS = 1_000;
/** Names of incomplete downloads. */
const ARRIVING = /\.(part|crdownload|wkdownload|tmp)$|^\./;

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
  const { driver } = browser;
  const picture = (name) => shot(driver, path.join(pictures, `${browser.name}-${name}.png`));
  const find = (selector) => driver.findElement(By.css(selector));
  /** Replaces a field's text and leaves the field. */
  const type = async (selector, text, leaving) => {
    await find(selector).click();
    await driver.executeScript("document.activeElement.select()");
    await driver.actions().sendKeys(text, leaving).perform();
  };
  const untilEdits = (count) => until(driver, `document.querySelectorAll("#history .check").length === ${count}`, `${count} edits`);

  await driver.get(url);
  await noteErrors(driver);
  await until(driver, `document.querySelector("#privacy-count[data-requests='0']")`, "the page with all its parts");
  await picture("arrived");
  await find("#photo-file").sendKeys(SAMPLE);
  await untilFace(driver);
  await find("#expert").click();
  const found = await picture("found");
  assert.ok(colourCount(found) > 40, "the face has no colours");
  const drawnBy = await renderer(driver);

  const selectBy = async (mode) => {
    await find("#tab-shape").click();
    await find(`label:has(input[name='selection'][value='${mode}'])`).click();
  };
  await selectBy("landmark");
  await type("#landmark-search", "nose tip", Key.ENTER);
  await type("#landmark-offset [data-axis='y'] .number-field", "9", Key.TAB);
  await untilEdits(1);
  assert.ok(difference(found, await picture("by-number")) > 0.001, "the number did not change the picture");
  const lifted = await mesh(browser);

  await selectBy("region");
  const held = await picture("held");
  await drag(driver, "#viewport", { x: 40, y: -30 });
  await untilEdits(2);
  assert.ok(difference(held, await picture("by-hand")) > 0.001, "the drag did not change the picture");
  assert.notDeepEqual((await mesh(browser)).positions, lifted.positions);

  await find("#toolbar [data-action='undo']").click();
  await untilEdits(1);
  assert.deepEqual(await mesh(browser), lifted);
  await checkGlb(await download(browser, "#save-main"));
  await picture("downloaded");

  await driver.sleep(SAVE_MS);
  await driver.navigate().refresh();
  await noteErrors(driver);
  await until(driver, `document.querySelector("#continue").checkVisibility()`, "the offer to resume");
  await find("#continue").click();
  await untilFace(driver);
  await untilEdits(1);
  await picture("again");
  assert.deepEqual(await mesh(browser), lifted);

  await find("#photo-file").sendKeys(AVIF);
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
export async function runElementScenario({ driver, name, errors }, url, pictures) {
  const picture = (what) => shot(driver, path.join(pictures, `${name}-element-${what}.png`));
  const untilEdits = (count) => until(driver, `document.querySelector("rosto-studio").state.edits === ${count}`, `${count} edits`);

  await driver.get(url);
  await noteErrors(driver);
  await until(driver, `document.querySelector("rosto-studio")?.state?.faces === 1`, "the element's face");
  const found = await picture("found");
  await drag(driver, "rosto-studio", { x: 30, y: 20 });
  await untilEdits(1);
  await driver.findElement(By.id("wider")).click();
  await untilEdits(2);
  assert.ok(difference(found, await picture("edited")) > 0.001, "the edits do not show");

  const glb = await driver.executeScript(async () => {
    const bytes = new Uint8Array(await (await document.querySelector("rosto-studio").getGlb()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  await checkGlb(Buffer.from(glb, "base64"));
  assert.deepEqual(await errors(), []);
}

/** Name of the WebGL2 renderer. @param {import("selenium-webdriver").WebDriver} driver @returns {Promise<string>} */
async function renderer(driver) {
  const name = await driver.executeScript(() => {
    const gl = document.querySelector("#viewport").getContext("webgl2");
    const unmasked = gl?.getExtension("WEBGL_debug_renderer_info");
    return gl?.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  });
  assert.ok(name, "the page does not draw in WebGL2");
  return name;
}

/** @param {Browser} browser */
async function mesh(browser) {
  await browser.driver.findElement(By.id("tab-export")).click();
  return JSON.parse((await download(browser, "#panel [data-action='download-json']")).toString());
}

/** @param {Browser} browser @param {string} button */
async function download({ driver, downloads }, button) {
  for (const name of await readdir(downloads)) await rm(path.join(downloads, name));
  await driver.findElement(By.css(button)).click();
  let bytes = Buffer.alloc(0);
  await driver.wait(async () => {
    const [name, ...others] = await readdir(downloads);
    if (!name || others.length > 0 || ARRIVING.test(name)) return false;
    const before = bytes;
    bytes = await readFile(path.join(downloads, name));
    return bytes.length > 0 && bytes.equals(before);
  }, WAIT_MS, `${button} downloaded nothing`);
  return bytes;
}

/** @param {import("selenium-webdriver").WebDriver} driver */
function untilFace(driver) {
  return until(driver, `document.querySelector("body[data-state='face']:not([data-texture]):has(#progress[hidden])")`, "a face");
}
