import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { PNG } from "pngjs";
import { test } from "./fixtures.mjs";
import { difference, differenceNear } from "./pixels.mjs";

test.use({ visit: { expert: true } });

const PAINTS = ["picture", "colours", "clay", "normals", "response", "distortion"];

test("each display mode changes the view; numeric ones show a legend", { tag: "@eyes" }, async ({ editor, page }) => {
  // Without a radius, the influence covers most of the face.
  await editor.reveal("#edit-nearby");
  await page.uncheck("#edit-nearby");
  await editor.findLandmark("nose tip");
  const nose = await editor.toViewPixels(await editor.tagPosition());
  await editor.setOffset("z", 8);
  await editor.unfold("section-view");
  const views = [];
  for (const paint of PAINTS) {
    await page.check(`input[name="shading"][value="${paint}"]`, { force: true });
    views.push(await editor.view());
    assert.equal(await page.isVisible("#shading .legend .caption"), paint === "response" || paint === "distortion", paint);
  }
  assert.match(await page.innerText("#shading .legend .caption"), /%/);
  for (const [one, view] of views.entries()) {
    for (const [other, another] of views.slice(0, one).entries()) {
      assert.ok(differenceNear(view, another, nose, 150) > 0.05, `${PAINTS[one]} looks like ${PAINTS[other]}`);
    }
  }
});

test("lines, points, density and openings change the view and can be reverted", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  const first = await editor.view();
  for (const box of ["view-wireframe", "view-dots"]) {
    await page.check(`#${box}`);
    assert.ok(difference(first, await editor.view()) > 0.01, `${box} changed nothing`);
    await page.uncheck(`#${box}`);
  }
  for (const [select, usual, other] of [["density", "2", "0"], ["triangulation", "canonical", "tessellation"]]) {
    await page.selectOption(`#${select}`, other);
    assert.ok(difference(first, await editor.view()) > 0.003, `${select} changed nothing`);
    await page.selectOption(`#${select}`, usual);
  }
  assert.equal(difference(first, await editor.view()), 0, "the view was not restored");
});

test("the photo keeps its light unless the lamp is enabled; sphere and colour control the lamp", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("light");
  assert.ok(await page.locator("#light-lamp").evaluate((lamp) => lamp.disabled), "the lamp is enabled without effect");
  const own = await editor.view();
  await page.check("#light-photo");
  assert.ok(difference(own, await editor.view()) > 0.05, "the lamp does not light the photo");
  await page.uncheck("#light-photo");
  assert.equal(difference(own, await editor.view()), 0);
  await page.check("input[name='shading'][value='clay']", { force: true });
  assert.ok(await page.locator("#light-lamp").evaluate((lamp) => !lamp.disabled));
  assert.ok(await page.isHidden("#light-photo"));
  const first = await editor.view();
  await page.locator("#light-sphere").scrollIntoViewIfNeeded();
  const box = await page.locator("#light-sphere").boundingBox();
  await editor.drag({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, { x: 0.4 * box.width, y: 0 });
  const fields = await page.locator("#light-lamp .number-field").all();
  const [azimuth, elevation] = await Promise.all(fields.map(async (field) => Number(await field.inputValue())));
  assert.ok(azimuth > 60 && Math.abs(elevation) < 5, `the light is at ${azimuth}°, ${elevation}°`);
  const sun_px = async () => Number(await page.getAttribute("#light-sun", "cx"));
  assert.ok(await sun_px() > 34);
  await fields[0].fill("-60");
  await fields[0].press("Enter");
  assert.ok(await sun_px() < -34);
  await fields[0].fill(String(azimuth));
  await fields[0].press("Enter");
  assert.ok(await sun_px() > 34);
  const fromTheRight = await editor.view();
  assert.ok(difference(first, fromTheRight) > 0.05);
  await page.fill("#light-colour", "#ff4000");
  assert.ok(difference(fromTheRight, await editor.view()) > 0.05);
});

test("holding the button or B shows the original; a click shows before and after side by side", { tag: "@eyes" }, async ({ editor, page }) => {
  const before = await editor.view();
  await editor.findLandmark("nose tip");
  const nose = await editor.toViewPixels(await editor.tagPosition());
  await editor.setOffset("y", 12);
  const beside = await editor.emptyPoint();
  await page.mouse.click(beside.x, beside.y);
  const after = await editor.view();
  const button = await page.locator("#compare").boundingBox();
  await page.mouse.move(button.x + 10, button.y + 10);
  await page.mouse.down();
  await page.waitForSelector("[data-comparing]");
  // A hidden button would be released.
  await editor.frames(3);
  const held = PNG.sync.read(await page.locator("#viewport").screenshot());
  assert.ok(differenceNear(after, held, nose, 60) > 0.05, "the edit is still visible");
  assert.ok(differenceNear(before, held, nose, 60) < 0.001, "the view is not the original");
  await page.mouse.up();
  assert.ok(await page.isHidden("#wipe"), "a long press opened the comparison");
  assert.ok(difference(after, await editor.view()) < 0.001);
  await page.mouse.click(beside.x, beside.y);
  await page.keyboard.down("b");
  // Keyboard input shows the focus ring around the view.
  assert.ok(differenceNear(before, await editor.view(), nose, 120) < 0.001);
  await page.keyboard.up("b");

  await editor.findLandmark("nose tip");
  await page.click("#compare");
  assert.ok(await page.isHidden("#landmark-tag"), "the tag is visible during the comparison");
  for (const [key, shows] of /** @type {const} */ ([["Home", after], ["End", before]])) {
    await page.focus("#wipe");
    await page.keyboard.press(key);
    const seen = await editor.view();
    assert.ok(difference(shows, seen) < 0.004, `${key}: ${difference(shows, seen)}`);
  }
  const edge = await page.locator("#wipe").boundingBox();
  await editor.drag({ x: edge.x + edge.width - 20, y: edge.y + edge.height / 2 }, { x: 20 - edge.width / 2, y: 0 });
  const both = await editor.view();
  const shares = [before, after].map((one) => differenceNear(one, both, nose, 60));
  assert.ok(Math.min(...shares) > 0.01, `${shares}`);
  await page.keyboard.press("Escape");
  assert.ok(await page.isHidden("#wipe"));
  await page.click("#compare");
  await editor.openFace();
  assert.ok(await page.isHidden("#wipe"), "the comparison stays open for another face");
});

test("a saved picture shows the face without marks", { tag: "@eyes" }, async ({ editor, page }) => {
  const plain = PNG.sync.read(await editor.download("download-picture"));
  await editor.findLandmark("nose tip");
  await editor.reveal("#edit-pin");
  await page.check("#edit-pin");
  await editor.reveal("#anchors-shown");
  const unmarked = await editor.view();
  await page.check("#anchors-shown");
  assert.ok(difference(unmarked, await editor.view()) > 0, "the anchors are not marked");
  assert.deepEqual(PNG.sync.read(await editor.download("download-picture")), plain);
});

test("auto-rotate runs until it is switched off", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  const first = await editor.view();
  await page.check("#view-turntable");
  const shot = async () => PNG.sync.read(await page.locator("#viewport").screenshot());
  await expect.poll(async () => difference(first, await shot()), { message: "the face did not rotate" }).toBeGreaterThan(0.02);
  await page.uncheck("#view-turntable");
  const turned = await editor.view();
  await editor.frames(20);
  assert.equal(difference(turned, await editor.view()), 0, "the rotation did not stop");
});

test("the background can have any colour, in the view and the saved picture, where it can also be transparent", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  await page.fill("#background-colour", "#0cb4fa");
  assert.ok(await page.isChecked("#background-plain"));
  assert.deepEqual(corner(await editor.view()), [0x0c, 0xb4, 0xfa, 255]);
  await editor.unfold("section-export");
  const cutOut = PNG.sync.read(await editor.download("download-picture"));
  assert.deepEqual(corner(cutOut), [0, 0, 0, 0]);
  assert.equal(middle(cutOut)[3], 255, "the face itself is transparent");
  await page.uncheck("#export-transparent");
  const whole = PNG.sync.read(await editor.download("download-picture"));
  assert.deepEqual(corner(whole), [0x0c, 0xb4, 0xfa, 255]);
  assert.deepEqual(middle(whole), middle(cutOut));
  await editor.reveal("#background-plain");
  await page.uncheck("#background-plain");
  assert.notDeepEqual(corner(await editor.view()), [0x0c, 0xb4, 0xfa, 255]);
});

/** @param {import("./pixels.mjs").Pixels} pixels */
const corner = ({ data }) => [...data.subarray(0, 4)];

/** @param {import("./pixels.mjs").Pixels} pixels */
function middle({ width, height, data }) {
  const at = 4 * (Math.floor(height / 2) * width + Math.floor(width / 2));
  return [...data.subarray(at, at + 4)];
}
