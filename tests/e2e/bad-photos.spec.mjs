import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { asJpeg, enormousPng, faceless, heic, outOfFocus, text } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

test("invalid files show an error, doubtful faces a remark, and the work stays", { tag: "@usual" }, async ({ visitor, page }) => {
  await visitor.dropSample();
  await visitor.move("nose tip", "z", 4);
  const work = await visitor.meshJson("mm");

  const jpeg = await asJpeg(page, await readFile(SAMPLE));
  const photos = [
    { bytes: faceless(), name: "sky.png", code: "no-face-found", says: /No face found/ },
    { bytes: text(), name: "diary.jpg", code: "not-a-picture", says: /isn’t a picture/ },
    { bytes: jpeg.subarray(0, jpeg.length / 2), name: "half.jpg", code: "damaged-picture", says: /damaged or incomplete/ },
    { bytes: heic(), name: "IMG_0001.HEIC", code: "unsupported-format", says: /Most Compatible/ },
    { bytes: enormousPng(), name: "map.png", code: "too-many-pixels", says: /too many pixels/ },
  ];
  for (const { bytes, name, code, says } of photos) {
    await visitor.drop(bytes, name);
    await page.waitForSelector(`#notice[data-code="${code}"]`);
    await page.waitForSelector("#progress", { state: "hidden" });
    assert.match((await visitor.notice()).text, says);
    const told = await page.locator("body").innerText();
    assert.equal(told.match(new RegExp(says, "g"))?.length, 1, `${name} is reported more than once`);
    if (code === "no-face-found") await page.keyboard.press("Escape");
    else await page.click("#notice-close");
    assert.ok(await page.isHidden("#notice"));
    assert.deepEqual(await visitor.meshJson("mm"), work, `${name} changed the work on screen`);
  }

  await visitor.drop(jpeg, "portrait.jpg");
  await page.waitForFunction(() => document.querySelectorAll("#history .check").length === 0);
  assert.ok(await page.isHidden("#notice"));
  await visitor.drop(await outOfFocus(page, await readFile(SAMPLE)), "blurred.png");
  assert.equal((await visitor.notice()).code, "may-not-be-a-face");
  await visitor.untilFace();
  await visitor.dropSample();
  await page.waitForSelector("#notice", { state: "hidden" });
});
