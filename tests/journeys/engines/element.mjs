import assert from "node:assert/strict";
import path from "node:path";
import { difference } from "../pixels.mjs";
import { checkGlb, shot, until } from "./core.mjs";
import { Hand } from "./hand.mjs";

/**
 * The example page with the element, in every engine: the face comes, a hand and a slider reshape it, and its GLB is valid.
 *
 * @param {import("./hand.mjs").Driver} driver
 * @param {string} url
 * @param {string} pictures the folder for screenshots
 */
export async function element(driver, url, pictures) {
  const picture = (/** @type {string} */ name) => shot(driver, path.join(pictures, `${driver.engine.toLowerCase()}-element-${name}.png`));
  const untilEdits = (/** @type {number} */ count) => until(driver, `document.querySelector("rosto-studio").state.edits === ${count}`, `${count} edits`);

  await driver.open(url);
  await until(driver, `document.querySelector("rosto-studio")?.state?.faces === 1`, "the element's face");
  const found = await picture("found");
  const box = await driver.evaluate(`
    const { x, y, width, height } = document.querySelector("rosto-studio").getBoundingClientRect();
    return { x, y, width, height };`);
  await new Hand(driver).drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, { x: 30, y: 20 });
  await untilEdits(1);
  await driver.evaluate(`document.querySelector("#wider").click()`);
  await untilEdits(2);
  assert.ok(difference(found, await picture("edited")) > 0.001, "the edits do not show");

  const glb = await driver.evaluate(`
    const bytes = new Uint8Array(await (await document.querySelector("rosto-studio").getGlb()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));`);
  await checkGlb(Buffer.from(glb, "base64"));
}
