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

test("the panel shows the estimated distance, which can be changed and is saved with the work", { tag: ["@eyes", "@rare"] }, async ({ editor, page }) => {
  await editor.unfold("section-size");
  assert.match(await page.innerText("#size-camera"), /about \d+ cm ± \d+, estimated from the face/);
  assert.match(await page.innerText("#size-pose"), /Head turned -?\d+° sideways/);
  const [found, before] = [await measures(page), await editor.view()];
  assert.ok(found["Face width"] > 100 && found["Face width"] < 180, `${found["Face width"]} mm wide`);
  const number = page.locator("#size-distance .number-field");
  const usual = await number.inputValue();
  await number.fill("25");
  await number.press("Enter");
  assert.match(await page.innerText("#size-camera"), /25 cm \(set by you\)/);
  const near = await measures(page);
  assert.ok(near["Face width"] > found["Face width"] * 1.02, "the face is not wider for a nearer camera");
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
  assert.equal((await measures(page))["Face width"], chosen["Face width"]);
});

test("the tape measures the distance of two points with its error", async ({ editor, page }) => {
  await editor.findLandmark("right mouth corner");
  await editor.unfold("section-size");
  await page.click("[data-action='tape.start']");
  assert.match(await page.innerText("#tape-result"), /From right mouth corner · 61: now select another point/);
  await editor.findLandmark("left mouth corner");
  await editor.unfold("section-size");
  const result = await page.innerText("#tape-result");
  const [straight, along] = [...result.matchAll(/(\d+) mm ± \d+/g)].map(([, length]) => Number(length));
  const mouth = (await measures(page))["Mouth width"];
  assert.equal(straight, mouth, result);
  assert.ok(along > straight, result);
});

test("a tape is cleared if a coarser mesh lacks its start", { tag: "@rare" }, async ({ editor, page }) => {
  await editor.unfold("section-view");
  await page.selectOption("#density", "1");
  await editor.unfold("section-landmark");
  await page.check("input[name='selection'][value='point']", { force: true });
  await editor.findLandmark("1200");
  await editor.unfold("section-size");
  await page.click("[data-action='tape.start']");
  assert.match(await page.innerText("#tape-result"), /From point 1200:/);
  await editor.unfold("section-view");
  await page.selectOption("#density", "0");
  await editor.findLandmark("nose tip");
  await editor.unfold("section-size");
  assert.match(await page.innerText("#tape-result"), /Select a point/);
});
