import assert from "node:assert/strict";
import { readdir, readFile, rm, writeFile } from "node:fs/promises";
import path from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { PNG } from "pngjs";
import { validateGlb } from "../validate-glb.mjs";
import { WAIT_MS } from "./drivers.mjs";

/** @typedef {import("./browsers.mjs").Browser} Browser */

const POLL_MS = 200;
/** Number of vertices at the default density. */
const SMOOTH = 7257;
/** Names of incomplete downloads. */
const ARRIVING = /\.(part|crdownload|wkdownload|tmp)$|^\./;

/** @param {() => Promise<boolean>} holds @param {string} failure */
async function wait(holds, failure) {
  for (const end = performance.now() + WAIT_MS; !(await holds()); await sleep(POLL_MS)) {
    assert.ok(performance.now() < end, failure);
  }
}

/**
 * Waits for a condition. Retries while a navigation leaves the driver without a page.
 *
 * @param {Browser} browser
 * @param {string} condition
 * @param {string} what
 */
export async function until(browser, condition, what) {
  const holds = () => browser.evaluate(`Boolean(${condition})`).catch((error) => {
    if (browser.crashed(error)) throw error;
    return false;
  });
  await wait(holds, `${what} did not appear`);
}

/** Bytes that a button downloads. @param {Browser} browser @param {string} button */
export async function download({ click, downloads }, button) {
  for (const name of await readdir(downloads)) await rm(path.join(downloads, name));
  await click(button);
  let bytes = Buffer.alloc(0);
  const isSaved = async () => {
    const [name, ...others] = await readdir(downloads);
    if (!name || others.length > 0 || ARRIVING.test(name)) return false;
    const before = bytes;
    bytes = await readFile(path.join(downloads, name));
    return bytes.length > 0 && bytes.equals(before);
  };
  await wait(isSaved, `${button} downloaded nothing`);
  return bytes;
}

/** Draws some frames and takes a screenshot. @param {Browser} browser @param {string} file */
export async function shot(browser, file) {
  await browser.evaluate(async () => {
    for (let frame = 0; frame < 3; frame++) await new Promise(requestAnimationFrame);
  });
  const png = Buffer.from(await browser.screenshot());
  await writeFile(file, png);
  return PNG.sync.read(png);
}

/** @param {Buffer} glb */
export async function checkGlb(glb) {
  assert.deepEqual((await validateGlb(glb)).messages, []);
  const json = JSON.parse(glb.subarray(20, 20 + glb.readUInt32LE(12)).toString());
  assert.equal(json.accessors[json.meshes[0].primitives[0].attributes.POSITION].count, SMOOTH);
}
