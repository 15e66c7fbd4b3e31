import assert from "node:assert/strict";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { colourCount } from "./pixels.mjs";
import { readFile } from "node:fs/promises";
import { SAMPLE } from "./visitor.mjs";

test("without WebGPU and WebGL2 the page says so, and still draws the landmarks on the photo", { tag: "@no-gpu" }, async ({ visitor }) => {
  const { code, text } = await visitor.notice();
  assert.equal(code, "no-webgl");
  assert.match(text, /cannot draw in 3D/);
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await visitor.page.waitForSelector("body[data-state='photo']");
  const photo = PNG.sync.read(await visitor.page.locator("#photo-picture").screenshot());
  assert.ok(colourCount(photo) > 100, "the photo is not drawn");
});
