import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";

const picture = (name) => readFile(new URL(`pictures/${name}`, import.meta.url));

/** Nose tip and chin of the drawn face, as fractions of the picture's size. */
const NOSE_TIP = { landmark: 1, x: 0.5, y: 0.64 };
const CHIN = { landmark: 152, x: 0.5, y: 0.9 };
/** Tolerance as a fraction of the photo's size; 0.01 is 2 px. */
const NEAR = 0.04;

test("an AVIF, which the browser decodes, becomes an upright face in its colours, or shows an error", async ({ visitor, page }) => {
  const whole = await picture("drawn-face.avif");
  await visitor.drop(whole, "me.avif");
  await visitor.untilFace();
  assert.ok(await page.isHidden("#notice"));
  const { positions, colours } = await visitor.meshJson("image");
  for (const { landmark, x, y } of [NOSE_TIP, CHIN]) {
    const [found_x, found_y] = positions[landmark];
    assert.ok(Math.hypot(found_x - x, found_y - y) < NEAR, `landmark ${landmark} is at ${found_x}, ${found_y}`);
  }
  const [red, green, blue] = colours[NOSE_TIP.landmark];
  assert.ok(red > green + 20 && green > blue + 10, `the nose has the colour ${red}, ${green}, ${blue}`);

  const work = await visitor.meshJson("mm");
  for (const { bytes, code } of [
    { bytes: await picture("enormous.avif"), code: "too-many-pixels" },
    { bytes: whole.subarray(0, whole.length / 2), code: "unsupported-format" },
  ]) {
    await visitor.drop(bytes, "other.avif");
    await page.waitForSelector(`#notice[data-code="${code}"]`);
    await page.waitForSelector("#progress", { state: "hidden" });
    await page.click("#notice-close");
    assert.deepEqual(await visitor.meshJson("mm"), work);
  }
});
