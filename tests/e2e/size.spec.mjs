import assert from "node:assert/strict";
import { test } from "./fixtures.mjs";
import { difference } from "./pixels.mjs";

test.use({ visit: { expert: true } });

/** Measurements on the panel: name to length in mm. Read in one evaluation, because the panel may replace the list. */
function measures(page) {
  return page.locator("#size-measures dt").evaluateAll((names) =>
    Object.fromEntries(names.map((name) => [name.textContent, Number.parseFloat(name.nextElementSibling.textContent)])),
  );
}

test("the panel shows the estimated distance, which can be changed and is saved with the work", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-size");
  assert.match(await page.innerText("#size-camera"), /about \d+ cm \(\d+ to \d+ cm\), estimated from the face/);
  assert.match(await page.innerText("#size-pose"), /Head turned -?\d+° sideways/);
  const [found, before] = [await measures(page), await editor.view()];
  assert.ok(found["Face height"] > 140 && found["Face height"] < 210, `${found["Face height"]} mm high`);
  const number = page.locator("#size-distance .number-field");
  const usual = await number.inputValue();
  await number.fill("25");
  await number.press("Enter");
  assert.match(await page.innerText("#size-camera"), /25 cm \(set by you\)/);
  const near = await measures(page);
  assert.ok(near["Jaw width"] > found["Jaw width"], "the jaw is not wider for a nearer camera");
  assert.ok(difference(before, await editor.view()) > 0.005, "the model did not follow");
  await page.click("[data-action='size.known']");
  assert.equal(await number.inputValue(), usual);
  assert.deepEqual(await measures(page), found);

  await number.fill("31");
  await number.press("Enter");
  const chosen = await measures(page);
  const file = await editor.download("download-glb");
  await page.reload();
  await editor.drop(file, "rosto.glb");
  await editor.untilFace();
  await editor.unfold("section-size");
  assert.equal(await number.inputValue(), "31");
  assert.equal((await measures(page))["Jaw width"], chosen["Jaw width"]);
});

test("four taps on a bank card in the photo measure the face, also after a reload", { tag: "@eyes" }, async ({ editor, page }) => {
  await editor.unfold("section-size");
  const width = page.locator("#size-measures dt", { hasText: "Face width" }).locator("xpath=following-sibling::dd[1]");
  assert.match(await width.innerText(), /Too uncertain/);
  await page.click("[data-action='card.mark']");
  assert.match(await page.innerText("#card-help"), /corner 1 of 4/);
  await editor.frames(5);
  const chin = await editor.landmarkPosition(152);
  const tap = (/** @type {number} */ x, /** @type {number} */ y) => page.mouse.click(chin.x + 0.7 * x, chin.y + 0.7 * y);
  for (const side of [1, -1]) await tap(60 * side, 60 * side);
  await tap(60, -60);
  assert.match(await page.innerText("#card-help"), /corner 4 of 4/);
  await tap(-60, 60);
  assert.equal((await editor.notice()).code, "not-a-card");
  await page.click("#notice-close");
  for (const [x, y] of [[-85.6, -53.98], [85.6, 53.98], [85.6, -53.98], [-85.6, 53.98]]) await tap(x ?? 0, y ?? 0);
  await page.waitForFunction(() => /bank card, to about 1/.test(document.querySelector("#size-source")?.textContent ?? ""));
  const measured = await width.innerText();
  assert.match(measured, /\d+ mm ± \d+/);
  await editor.reloadAndResume();
  await editor.unfold("section-size");
  assert.equal(await width.innerText(), measured, "the card is not saved with the photo");
  await page.click("[data-action='card.forget']");
  assert.match(await page.innerText("#size-source"), /irises/);
});
