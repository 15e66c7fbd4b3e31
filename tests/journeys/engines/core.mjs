import assert from "node:assert/strict";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { PNG } from "pngjs";
import { colourCount, difference } from "../pixels.mjs";
import { validateGlb } from "../validate-glb.mjs";
import { SAMPLE } from "../visitor.mjs";
import { BrowserCrashed, Hand } from "./hand.mjs";

/** @typedef {import("./hand.mjs").Driver} Driver */

/** A face in a format that the browser decodes. */
const AVIF = new URL("../pictures/drawn-face.avif", import.meta.url);

/** Points of a face as it is at first. */
const SMOOTH = 7257;
const WAIT_MS = 120_000;
const POLL_MS = 100;
/** Work is kept within this time after the last change. */
const KEPT_MS = 1_000;

/** What a browser calls a file that is still arriving. */
const ARRIVING = /\.(part|crdownload|wkdownload|tmp)$/;

/**
 * The way through the page that has to work in every engine: arrive, drop a photo, edit by number and by hand, undo,
 * download, reload, go on; drop a photo that the browser decodes.
 *
 * @param {Driver} driver
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 * @returns {Promise<string>} what draws
 */
export async function core(driver, url, pictures) {
  const hand = new Hand(driver);
  await mkdir(pictures, { recursive: true });
  const picture = (/** @type {string} */ name) => shot(driver, path.join(pictures, `${driver.engine.toLowerCase()}-${name}.png`));

  await driver.open(url);
  await until(driver, `document.querySelector("#privacy-count[data-requests='0']")`, "the page with all its parts");
  await picture("arrived");
  await drop(driver, await readFile(SAMPLE));
  await untilFace(driver);
  const found = await picture("found");
  assert.ok(colourCount(found) > 40, "the face has no colours");
  const drawnBy = await renderer(driver);

  await hand.type("#landmark-search", "nose tip", "enter");
  await hand.type("#landmark-sliders [data-axis='y'] input[type=number]", "9", "tab");
  await untilEdits(driver, 1);
  const byNumber = await picture("by-number");
  assert.ok(difference(found, byNumber) > 0.001, "the number did not change the picture");
  const lifted = await mesh(driver, hand);

  // The page may have less room now: some browsers show what they have downloaded.
  const tip = await tagged(driver);
  const held = await picture("held");
  await hand.drag(tip, { x: 40, y: -30 });
  await untilEdits(driver, 2);
  const byHand = await picture("by-hand");
  assert.ok(difference(held, byHand) > 0.001, "the drag did not change the picture");
  assert.notDeepEqual((await mesh(driver, hand)).positions, lifted.positions);

  await hand.click("#toolbar [data-action='undo']");
  await untilEdits(driver, 1);
  assert.deepEqual(await mesh(driver, hand), lifted);
  await checkGlb(await download(driver, hand, "download-glb"));
  await picture("downloaded");

  await new Promise((resolve) => setTimeout(resolve, KEPT_MS));
  await driver.reload();
  await until(driver, `document.querySelector("#continue").checkVisibility()`, "the offer to go on");
  await hand.click("#continue");
  await untilFace(driver);
  await untilEdits(driver, 1);
  await picture("again");
  assert.deepEqual(await mesh(driver, hand), lifted);

  await drop(driver, await readFile(AVIF));
  await untilEdits(driver, 0);
  await picture("decoded");
  assert.deepEqual(await driver.errors(), []);
  return drawnBy;
}

/** @param {Driver} driver @param {Uint8Array} bytes */
function drop(driver, bytes) {
  return driver.evaluate(`
    const bytes = Uint8Array.from(atob("${Buffer.from(bytes).toString("base64")}"), (letter) => letter.charCodeAt(0));
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([bytes], "portrait.png", { type: "image/png" }));
    for (const type of ["dragover", "drop"]) {
      document.querySelector("#stage").dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    }`);
}

/** What draws in WebGL2, as the browser names it. @param {Driver} driver @returns {Promise<string>} */
async function renderer(driver) {
  const name = await driver.evaluate(`
    const gl = document.querySelector("#viewport").getContext("webgl2");
    if (!gl) return null;
    const unmasked = gl.getExtension("WEBGL_debug_renderer_info");
    return gl.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER);`);
  assert.ok(name, "the page does not draw in WebGL2");
  return name;
}

/** Where the landmark is whose name is shown beside it. @param {Driver} driver @returns {Promise<{ x: number, y: number }>} */
async function tagged(driver) {
  await until(driver, `document.querySelector("#landmark-tag").checkVisibility()`, "the landmark's name");
  return driver.evaluate(`
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
    const stage = document.querySelector("#stage").getBoundingClientRect();
    const [x = 0, y = 0] = document.querySelector("#landmark-tag").dataset.place.split(" ").map(Number.parseFloat);
    return { x: stage.left + x, y: stage.top + y };`);
}

/** @param {Driver} driver @param {Hand} hand */
async function mesh(driver, hand) {
  return JSON.parse((await download(driver, hand, "download-json")).toString());
}

/** @param {Driver} driver @param {Hand} hand @param {string} action @returns {Promise<Buffer>} */
async function download(driver, hand, action) {
  for (const name of await readdir(driver.downloads)) await rm(path.join(driver.downloads, name));
  await driver.evaluate(`document.querySelector("#tab-export").click()`);
  await hand.click(`#panel [data-action="${action}"]`);
  return arrived(driver.downloads, action);
}

/** The one file in a folder, once it is all there. @param {string} folder @param {string} what */
async function arrived(folder, what) {
  let before = -1;
  for (const limit = performance.now() + WAIT_MS; performance.now() < limit; await pause()) {
    const names = await readdir(folder);
    const [name] = names;
    if (names.length !== 1 || ARRIVING.test(name)) continue;
    const bytes = await readFile(path.join(folder, name));
    if (bytes.length > 0 && bytes.length === before) return bytes;
    before = bytes.length;
  }
  throw new Error(`${what} did not arrive within ${WAIT_MS / 1000} s; there is ${(await readdir(folder)).join(", ") || "nothing"}`);
}

/** @param {Buffer} glb */
export async function checkGlb(glb) {
  assert.deepEqual(await validateGlb(new Uint8Array(glb)), { clean: true, counts: "0/0/0/0", messages: [] });
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
  assert.equal(json.accessors[json.meshes[0].primitives[0].attributes.POSITION].count, SMOOTH);
}

/** @param {Driver} driver */
async function untilFace(driver) {
  await until(driver, `document.body.dataset.state === "face" && document.querySelector("#progress").hidden && !document.body.hasAttribute("data-texture")`, "a face");
  await driver.evaluate(`for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);`);
}

/** @param {Driver} driver @param {number} count */
function untilEdits(driver, count) {
  return until(driver, `document.querySelectorAll("#history li").length === ${count}`, `${count} edits in the history`);
}

/**
 * Asks until it is so. While a page goes and the next comes, a driver may find nobody to ask: it is asked again.
 *
 * @param {Driver} driver @param {string} condition @param {string} what
 */
export async function until(driver, condition, what) {
  let unanswered;
  for (const limit = performance.now() + WAIT_MS; performance.now() < limit; await pause()) {
    try {
      if (await driver.evaluate(`return Boolean(${condition})`)) return;
    } catch (error) {
      if (error instanceof BrowserCrashed) throw error;
      unanswered = error;
    }
  }
  const notice = await driver.evaluate(`const notice = document.querySelector("#notice"); return notice?.hidden ? "" : notice?.innerText`);
  throw new Error(`${what} did not come within ${WAIT_MS / 1000} s. ${notice} ${(await driver.errors()).join("\n")}`, { cause: unanswered });
}

/** @param {Driver} driver @param {string} file */
export async function shot(driver, file) {
  await driver.evaluate(`for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);`);
  const png = await driver.screenshot();
  await writeFile(file, png);
  return PNG.sync.read(png);
}

function pause() {
  return new Promise((resolve) => setTimeout(resolve, POLL_MS));
}
