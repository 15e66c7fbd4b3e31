import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";

const DESKTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const SHORT = { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true };

test("the panel goes from photo to sliders, to the hand, to what was done, and ends with the advanced", async ({ open }) => {
  const visitor = await open(DESKTOP);
  const { page } = visitor;
  await visitor.openFace();
  const seen = () => page.locator("#sections h2:not(.visually-hidden)").evaluateAll((all) => all.filter((h2) => h2.checkVisibility()).map((h2) => h2.innerText));
  assert.deepEqual(await seen(), ["Photo", "Features", "Expressions", "Move by hand", "In the photo", "History", "Advanced"]);
  for (const id of ["operator", "constraint", "details", "anchors", "anchors-shown", "section-paper"]) {
    assert.ok(await page.isHidden(`#${id}`), id);
    assert.equal(await page.locator(`#section-advanced #${id}`).count(), 1, id);
  }
  await page.selectOption("#language", "pt");
  assert.deepEqual(await seen(), ["Foto", "Traços", "Expressões", "Mover à mão", "Na foto", "Histórico", "Avançado"]);
});

for (const [[device, options], tag] of alike(Object.entries({ desktop: DESKTOP, phone: PHONE, "phone on its side": SHORT }))) {
  test(`shape, view and export are tabs, by keys too, and the download is in sight on each: ${device}`, { tag }, async ({ open }) => {
    const visitor = await open(options);
    const { page } = visitor;
    await visitor.untilLoaded();
    assert.ok(await page.isHidden("[role=tablist]"));
    assert.ok(await page.isHidden("[data-action='download-glb']"), "there is nothing to download yet");
    await visitor.openFace();
    await page.focus("#tab-shape");
    const sections = { shape: "section-face", view: "section-view", export: "section-export" };
    for (const [key, tab] of [["ArrowRight", "view"], ["ArrowRight", "export"], ["ArrowRight", "shape"], ["ArrowLeft", "export"], ["Home", "shape"], ["End", "export"]]) {
      await page.locator("#sections").evaluate((sections) => (sections.scrollTop = 200));
      await page.keyboard.press(key);
      assert.equal(await page.getAttribute(`#tab-${tab}`, "aria-selected"), "true");
      assert.equal(await page.locator("[role=tab][aria-selected=true]").count(), 1);
      assert.equal(await page.locator("#sections").evaluate((sections) => sections.scrollTop), 0, "a tab begins at its top");
      for (const [name, section] of Object.entries(sections)) assert.equal(await page.isVisible(`#${section}`), name === tab, `${section} on ${tab}`);
      assert.ok(await isWholly(page, "[data-action='download-glb']"), tab);
    }
    assert.equal(await page.locator(".button.primary").evaluateAll((all) => all.filter((button) => button.checkVisibility()).length), 1);
    const [download] = await Promise.all([page.waitForEvent("download"), page.click("[data-action='download-glb']")]);
    assert.match(download.suggestedFilename(), /\.glb$/);
  });

  test(`the photo folds to a row with its face, which unfolds it and changes it: ${device}`, { tag }, async ({ open }) => {
    const visitor = await open(options);
    const { page } = visitor;
    await visitor.openFace();
    assert.ok(await page.isHidden("#photo-picture"));
    assert.ok(await page.isHidden("#drop-zone"));
    const row = await page.locator("#section-photo").boundingBox();
    assert.ok(row.height <= 64, `the row is ${row.height} px high`);
    assert.match(await page.innerText("#section-photo summary"), /512 × 512 px/);
    assert.ok((await colours(page)) > 100, "the row does not show the face");
    await page.click("#section-photo summary", { position: { x: 100, y: 20 } });
    const picture = await page.locator("#photo-picture").boundingBox();
    assert.ok(picture.width > 100 && picture.height > 100);
    assert.ok(await page.isVisible("#drop-zone"));
    // The file dialog is answered with a photo, which folds it again.
    await Promise.all([page.waitForEvent("filechooser"), page.click("#photo-change")]);
    await page.waitForSelector("#photo-picture", { state: "hidden" });
  });
}

test("the presets say which is on and what it means, and that none is", { tag: "@rare" }, async ({ open }) => {
  const visitor = await open(DESKTOP);
  const { page } = visitor;
  await visitor.openFace();
  const segments = () => page.locator("[data-choice='preset'] span").evaluateAll((all) => all.filter((span) => span.checkVisibility()).map((span) => span.innerText));
  const custom = page.locator("input[name='preset'][value='custom']");
  assert.deepEqual(await segments(), ["Sculpt", "Paper"]);
  assert.match(await page.innerText("#preset-help"), /goes where you put it/);
  await visitor.prefer("paper");
  assert.match(await page.innerText("#preset-help"), /two random points/);
  await visitor.reach("#mirror");
  await page.locator("#mirror").click();
  assert.deepEqual(await segments(), ["Sculpt", "Paper", "Custom"]);
  assert.ok(await custom.isChecked());
  assert.ok(await custom.isDisabled(), "it cannot be chosen");
  assert.match(await page.innerText("#preset-help"), /own choices/);
  await visitor.prefer("sculpt");
  assert.deepEqual(await segments(), ["Sculpt", "Paper"]);
  assert.ok(!(await custom.isChecked()));
});

for (const [size, panel_px] of [[[1280, 720], 320], [[720, 450], 280]]) {
  test(`segments of a row are of one height and one line in either language: ${size.join(" × ")}`, { tag: "@rare" }, async ({ open }) => {
    const visitor = await open({ viewport: { width: size[0], height: size[1] } });
    const { page } = visitor;
    await visitor.openFace();
    assert.equal((await page.locator("#panel").boundingBox()).width, panel_px);
    await visitor.reach("#mirror");
    await page.locator("#mirror").click();
    for (const language of ["en", "pt"]) {
      await visitor.speak(language);
      for (const tab of ["shape", "view", "export"]) {
        await page.click(`#tab-${tab}`);
        const heights = await page.locator(".choice-options span").evaluateAll((all) => all.filter((span) => span.checkVisibility()).map((span) => span.offsetHeight));
        assert.ok(heights.length > 0);
        assert.deepEqual([...new Set(heights)], [32], `${language}, ${tab}`);
        const wide = await page.locator(".choice-options").evaluateAll((all) => all.filter((row) => row.scrollWidth > row.clientWidth).map(({ id }) => id));
        assert.deepEqual(wide, [], `${language}, ${tab}`);
      }
    }
  });
}

for (const [[width, height], tag] of alike([[1280, 720], [720, 450], [844, 390], [360, 640]])) {
  test(`the list of keys is not cut, begins at its top, and can be left: ${width} × ${height}`, { tag }, async ({ open }) => {
    const visitor = await open({ viewport: { width, height } });
    const { page } = visitor;
    await visitor.openFace();
    for (const language of ["en", "pt"]) {
      await visitor.speak(language);
      for (const dialog of ["keys", "credits"]) {
        await page.evaluate((dialog) => document.querySelector(`[data-action='open-${dialog}']`).click(), dialog);
        const box = await page.locator(`#${dialog}`).boundingBox();
        assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, JSON.stringify(box));
        assert.equal(await page.locator(`#${dialog}`).evaluate((dialog) => dialog.scrollTop), 0);
        assert.equal(await page.locator(`#${dialog}`).evaluate((dialog) => dialog.scrollWidth - dialog.clientWidth), 0);
        if (height === 720) assert.equal(await page.locator(`#${dialog}`).evaluate((dialog) => dialog.scrollHeight - dialog.clientHeight), 0, "it has to be scrolled");
        assert.ok(await isWholly(page, `[data-action='close-${dialog}']`), `the way out of ${dialog} is out of sight`);
        await page.click(`[data-action='close-${dialog}']`);
      }
    }
  });
}

test("language and theme are in reach on a small screen while a face is open", { tag: "@rare" }, async ({ open }) => {
  const visitor = await open(PHONE);
  const { page } = visitor;
  await visitor.openFace();
  await page.locator("#language").scrollIntoViewIfNeeded();
  await page.selectOption("#language", "pt");
  assert.equal(await page.innerText("#tab-export"), "Exportar");
  const before = await page.getAttribute("html", "data-theme");
  await page.click("#theme");
  assert.notEqual(await page.getAttribute("html", "data-theme"), before);
});

test("fingers are told to tap and choose, a mouse to click and drop", async ({ open }) => {
  const texts = (visitor) => visitor.page.evaluate(() => ["welcome-title", "landmark-help"].map((id) => document.getElementById(id).textContent).join(" "));
  const phone = await open(PHONE);
  await phone.openFace();
  const byFinger = await texts(phone);
  assert.match(byFinger, /Choose or take a photo of a face.*Tap a point/);
  assert.doesNotMatch(byFinger, /\b(drop|click)\b/i);
  const desk = await open(DESKTOP);
  await desk.openFace();
  assert.match(await texts(desk), /Drop a photo of a face.*Click a point/);
});

test("no visitor who begins reads of landmarks, their count, or requests", async ({ open }) => {
  const JARGON = /landmark|request|0–467|0 to 467|\b468\b|requisi/i;
  for (const locale of ["en-GB", "pt-BR"]) {
    const visitor = await open({ ...DESKTOP, locale });
    const { page } = visitor;
    await visitor.untilLoaded();
    assert.doesNotMatch(await page.innerText("body"), JARGON);
    const steps = await page.locator("#progress").evaluate((progress) => progress.textContent);
    assert.doesNotMatch(steps, JARGON);
    await visitor.openFace();
    await visitor.slide("nose-width", 2);
    await visitor.unfold("section-photo");
    assert.doesNotMatch(await page.innerText("body"), JARGON);
  }
});

/** Whether all of an element is in the window and it is what a press in its middle meets. */
async function isWholly(page, selector) {
  return page.locator(selector).evaluate((element) => {
    const { left, right, top, bottom } = element.getBoundingClientRect();
    const hit = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
    return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && element.contains(hit);
  });
}

/** How many colours the small picture of the face has. */
function colours(page) {
  return page.locator("#photo-thumbnail").evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
}
