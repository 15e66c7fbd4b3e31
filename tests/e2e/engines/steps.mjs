import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { By, error as errors, Origin } from "selenium-webdriver";
import { validateGlb } from "../validate-glb.mjs";

/** @typedef {import("selenium-webdriver").WebDriver} WebDriver */

export const WAIT_MS = 120_000;
/** Number of vertices at the default density. */
const SMOOTH = 7257;
/** Steps of a drag, in whole pixels. */
const STEPS = 10;
/** Human speed, so that no engine merges two moves. */
const STEP_MS = 16;

/**
 * Waits for a condition. Retries while a navigation leaves the driver without a page.
 *
 * @param {WebDriver} driver
 * @param {string} condition
 * @param {string} what
 */
export async function until(driver, condition, what) {
  const holds = () => driver.executeScript(`return Boolean(${condition})`).catch((error) => {
    if (error instanceof errors.NoSuchSessionError) throw error;
    return false;
  });
  await driver.wait(holds, WAIT_MS, `${what} did not appear`);
}

/**
 * Drags from the middle of an element.
 *
 * @param {WebDriver} driver
 * @param {string} selector
 * @param {{ x: number, y: number }} by CSS px
 */
export async function drag(driver, selector, by) {
  const actions = driver.actions().move({ origin: await driver.findElement(By.css(selector)), duration: 0 }).press();
  for (let step = 0; step < STEPS; step++) {
    actions.move({ x: by.x / STEPS, y: by.y / STEPS, origin: Origin.POINTER, duration: STEP_MS });
  }
  await actions.release().perform();
}

/** Draws some frames and takes a screenshot. @param {WebDriver} driver @param {string} file */
export async function shot(driver, file) {
  await driver.executeScript(async () => {
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
  });
  // chromedriver's screenshots time out after 10 s, which is too short for a busy machine without a GPU.
  const isChromium = "sendAndGetDevToolsCommand" in driver;
  const base64 = isChromium ? (await driver.sendAndGetDevToolsCommand("Page.captureScreenshot", {})).data : await driver.takeScreenshot();
  const png = Buffer.from(base64, "base64");
  await writeFile(file, png);
  return PNG.sync.read(png);
}

/** @param {Buffer} glb */
export async function checkGlb(glb) {
  assert.deepEqual((await validateGlb(glb)).messages, []);
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
  assert.equal(json.accessors[json.meshes[0].primitives[0].attributes.POSITION].count, SMOOTH);
}
