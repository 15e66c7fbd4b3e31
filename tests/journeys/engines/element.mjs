import assert from "node:assert/strict";
import path from "node:path";
import { difference } from "../pixels.mjs";
import { noteErrors } from "./browsers.mjs";
import { checkGlb, drag, shot, until } from "./steps.mjs";

/**
 * The example page with the element: the face comes, a drag and a slider reshape it, and its GLB is valid.
 *
 * @param {import("./browsers.mjs").Browser} browser
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 */
export async function walkElement(browser, url, pictures) {
  const { driver, name, errors } = browser;
  const picture = (/** @type {string} */ what) => shot(browser, path.join(pictures, `${name}-element-${what}.png`));
  const untilEdits = (/** @type {number} */ count) => until(driver, `document.querySelector("rosto-studio").state.edits === ${count}`, `${count} edits`);

  await driver.get(url);
  await noteErrors(driver);
  await until(driver, `document.querySelector("rosto-studio")?.state?.faces === 1`, "the element's face");
  const found = await picture("found");
  const middle = await driver.executeScript(() => {
    const { x, y, width, height } = document.querySelector("rosto-studio").getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  });
  await drag(driver, middle, { x: 30, y: 20 });
  await untilEdits(1);
  await driver.executeScript(() => document.querySelector("#wider").click());
  await untilEdits(2);
  assert.ok(difference(found, await picture("edited")) > 0.001, "the edits do not show");

  const glb = await driver.executeScript(async () => {
    const bytes = new Uint8Array(await (await document.querySelector("rosto-studio").getGlb()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  await checkGlb(Buffer.from(glb, "base64"));
  assert.deepEqual(await errors(), []);
}
