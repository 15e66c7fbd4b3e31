import assert from "node:assert/strict";
import { writeFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { error as errors, Origin } from "selenium-webdriver";
import { validateGlb } from "../validate-glb.mjs";

/** @typedef {import("selenium-webdriver").WebDriver} WebDriver */

export const WAIT_MS = 120_000;
/** Points of a face as it is at first. */
const SMOOTH = 7257;
const STEPS = 8;
/** A pointer that moves at a person's speed, so that no engine takes two moves for one. */
const STEP_MS = 16;

/** Waits for a condition. While one page leaves and the next comes, a driver may find none to ask: it asks again. @param {WebDriver} driver @param {string} condition @param {string} what */
export async function until(driver, condition, what) {
  const holds = async () => {
    try {
      return await driver.executeScript(`return Boolean(${condition})`);
    } catch (error) {
      if (error instanceof errors.NoSuchSessionError) throw error;
      return false;
    }
  };
  await driver.wait(holds, WAIT_MS, `${what} did not come`);
}

/** @param {WebDriver} driver @param {{ x: number, y: number }} from @param {{ x: number, y: number }} by CSS px */
export async function drag(driver, from, by) {
  const to = (/** @type {number} */ share) => ({ x: Math.round(from.x + share * by.x), y: Math.round(from.y + share * by.y), origin: Origin.VIEWPORT });
  const actions = driver.actions().move({ ...to(0), duration: 0 }).press();
  for (let step = 1; step <= STEPS; step++) actions.move({ ...to(step / STEPS), duration: STEP_MS });
  await actions.release().perform();
}

/** @param {WebDriver} driver */
export function frames(driver) {
  return driver.executeScript(async () => {
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
  });
}

/** @param {import("./browsers.mjs").Browser} browser @param {string} file */
export async function shot({ driver, screenshot }, file) {
  await frames(driver);
  const png = await screenshot();
  await writeFile(file, png);
  return PNG.sync.read(png);
}

/** @param {Buffer} glb */
export async function checkGlb(glb) {
  assert.deepEqual(await validateGlb(new Uint8Array(glb)), { clean: true, counts: "0/0/0/0", messages: [] });
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
  assert.equal(json.accessors[json.meshes[0].primitives[0].attributes.POSITION].count, SMOOTH);
}
