import assert from "node:assert/strict";
import { readFile, readdir, rm } from "node:fs/promises";
import path from "node:path";
import { By, Key } from "selenium-webdriver";
import { colourCount, difference } from "../pixels.mjs";
import { SAMPLE } from "../visitor.mjs";
import { noteErrors } from "./browsers.mjs";
import { checkGlb, drag, frames, shot, until, WAIT_MS } from "./steps.mjs";

/** @typedef {import("./browsers.mjs").Browser} Browser */

/** A face in a format that the browser decodes. */
const AVIF = new URL("../pictures/drawn-face.avif", import.meta.url);
/** Work is kept within this time after the last change. */
const KEPT_MS = 1_000;
/** What a browser calls a file that is still arriving. */
const ARRIVING = /\.(part|crdownload|wkdownload|tmp)$|^\./;

/**
 * The walk through the page that has to work in every engine: arrive, drop a photo, edit by number and by hand, undo,
 * download, reload, resume; drop a photo that the browser decodes.
 *
 * @param {Browser} browser
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 * @returns {Promise<string>} the renderer's name
 */
export async function walkCore(browser, url, pictures) {
  const { driver } = browser;
  const picture = (/** @type {string} */ name) => shot(browser, path.join(pictures, `${browser.name}-${name}.png`));
  const untilEdits = (/** @type {number} */ count) => until(driver, `document.querySelectorAll("#history li").length === ${count}`, `${count} edits in the history`);

  await driver.get(url);
  await noteErrors(driver);
  await until(driver, `document.querySelector("#privacy-count[data-requests='0']")`, "the page with all its parts");
  await picture("arrived");
  await drop(browser, await readFile(SAMPLE));
  await untilFace(browser);
  const found = await picture("found");
  assert.ok(colourCount(found) > 40, "the face has no colours");
  const drawnBy = await renderer(browser);

  await type(browser, "#landmark-search", "nose tip", Key.ENTER);
  await type(browser, "#landmark-sliders [data-axis='y'] input[type=number]", "9", Key.TAB);
  await untilEdits(1);
  assert.ok(difference(found, await picture("by-number")) > 0.001, "the number did not change the picture");
  const lifted = await mesh(browser);

  // The page may have less room now: some browsers show what they have downloaded.
  const tip = await tagged(browser);
  const held = await picture("held");
  await drag(driver, tip, { x: 40, y: -30 });
  await untilEdits(2);
  assert.ok(difference(held, await picture("by-hand")) > 0.001, "the drag did not change the picture");
  assert.notDeepEqual((await mesh(browser)).positions, lifted.positions);

  await click(browser, "#toolbar [data-action='undo']");
  await untilEdits(1);
  assert.deepEqual(await mesh(browser), lifted);
  await checkGlb(await download(browser, "download-glb"));
  await picture("downloaded");

  await driver.sleep(KEPT_MS);
  await driver.navigate().refresh();
  await noteErrors(driver);
  await until(driver, `document.querySelector("#continue").checkVisibility()`, "the offer to resume");
  await click(browser, "#continue");
  await untilFace(browser);
  await untilEdits(1);
  await picture("again");
  assert.deepEqual(await mesh(browser), lifted);

  await drop(browser, await readFile(AVIF));
  await untilEdits(0);
  await picture("decoded");
  assert.deepEqual(await browser.errors(), []);
  return drawnBy;
}

/** @param {Browser} browser @param {Buffer} bytes */
function drop({ driver }, bytes) {
  return driver.executeScript((base64) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], "portrait.png", { type: "image/png" }));
    for (const type of ["dragover", "drop"]) {
      document.querySelector("#stage").dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, bytes.toString("base64"));
}

/** @param {Browser} browser @param {string} selector */
async function click({ driver }, selector) {
  await driver.findElement(By.css(selector)).click();
}

/** Types into a field in place of what it holds, and leaves it. @param {Browser} browser @param {string} selector @param {string} text @param {string} leaving */
async function type(browser, selector, text, leaving) {
  await click(browser, selector);
  await browser.driver.executeScript("document.activeElement.select()");
  await browser.driver.actions().sendKeys(text, leaving).perform();
}

/** What draws in WebGL2, as the browser names it. @param {Browser} browser @returns {Promise<string>} */
async function renderer({ driver }) {
  const name = await driver.executeScript(() => {
    const gl = document.querySelector("#viewport").getContext("webgl2");
    if (!gl) return null;
    const unmasked = gl.getExtension("WEBGL_debug_renderer_info");
    return gl.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  });
  assert.ok(name, "the page does not draw in WebGL2");
  return name;
}

/** The landmark whose name is shown next to it. @param {Browser} browser @returns {Promise<{ x: number, y: number }>} */
async function tagged({ driver }) {
  await until(driver, `document.querySelector("#landmark-tag").checkVisibility()`, "the landmark's name");
  await frames(driver);
  return driver.executeScript(() => {
    const stage = document.querySelector("#stage").getBoundingClientRect();
    const [x = 0, y = 0] = document.querySelector("#landmark-tag").dataset.place.split(" ").map(Number.parseFloat);
    return { x: stage.left + x, y: stage.top + y };
  });
}

/** @param {Browser} browser */
async function mesh(browser) {
  return JSON.parse((await download(browser, "download-json")).toString());
}

/** @param {Browser} browser @param {string} action */
async function download(browser, action) {
  const { driver, downloads } = browser;
  for (const name of await readdir(downloads)) await rm(path.join(downloads, name));
  await click(browser, "#tab-export");
  await click(browser, `#panel [data-action="${action}"]`);
  let bytes = Buffer.alloc(0);
  await driver.wait(async () => {
    const [name, ...others] = await readdir(downloads);
    if (!name || others.length > 0 || ARRIVING.test(name)) return false;
    const before = bytes;
    bytes = await readFile(path.join(downloads, name));
    return bytes.length > 0 && bytes.equals(before);
  }, WAIT_MS, `${action} does not arrive`);
  return bytes;
}

/** @param {Browser} browser */
async function untilFace({ driver }) {
  await until(driver, `document.body.dataset.state === "face" && document.querySelector("#progress").hidden && !document.body.hasAttribute("data-texture")`, "a face");
  await frames(driver);
}
