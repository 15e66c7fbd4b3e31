import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { test } from "./fixtures.mjs";

const DESKTOP = { viewport: { width: 1280, height: 720 } };
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const SHORT = { viewport: { width: 844, height: 390 }, hasTouch: true, isMobile: true };

test.use({ visit: DESKTOP });

for (const [device, visit] of Object.entries({ desktop: DESKTOP, phone: PHONE, "phone on its side": SHORT })) {
  test(`shape, view and export are tabs with keyboard support and a visible download button, and the photo folds to a row: ${device}`, async ({ open }) => {
    const visitor = await open(visit);
    const { page } = visitor;
    await visitor.untilLoaded();
    assert.ok(await page.isHidden("[role=tablist]"));
    assert.ok(await page.isHidden("#save-main"), "the download button is visible without a face");
    await visitor.openFace();
    await page.focus("#tab-shape");
    const sections = { shape: "section-face", view: "section-view", export: "section-export" };
    for (const [key, tab] of [["ArrowRight", "view"], ["ArrowRight", "export"], ["ArrowRight", "shape"], ["ArrowLeft", "export"], ["Home", "shape"], ["End", "export"]]) {
      await page.locator("#sections").evaluate((sections) => (sections.scrollTop = 200));
      await page.keyboard.press(key);
      assert.deepEqual(await page.locator("[role=tab][aria-selected=true]").evaluateAll((tabs) => tabs.map(({ id }) => id)), [`tab-${tab}`]);
      assert.equal(await page.locator("#sections").evaluate((sections) => sections.scrollTop), 0, "the tab is not scrolled to its top");
      for (const [name, section] of Object.entries(sections)) assert.equal(await page.isVisible(`#${section}`), name === tab, `${section} on ${tab}`);
      await expectInReach(page.locator("#save-main"));
    }
    assert.match((await visitor.save("download-glb")).name, /\.glb$/);

    await page.click("#tab-shape");
    assert.ok(await page.isHidden("#photo-picture"));
    assert.ok(await page.isHidden("#drop-zone"));
    const row = await page.locator("#section-photo").boundingBox();
    assert.ok(row.height <= 64, `the row is ${row.height} px high`);
    assert.match(await page.innerText("#section-photo summary"), /512 × 512 px/);
    assert.ok((await colours(page)) > 100, "the thumbnail does not show the face");
    await page.click("#section-photo summary", { position: { x: 100, y: 20 } });
    const picture = await page.locator("#photo-picture").boundingBox();
    assert.ok(picture.width > 100 && picture.height > 100);
    assert.ok(await page.isVisible("#drop-zone"));
    // The file dialog is answered with a photo, which folds the section.
    await Promise.all([page.waitForEvent("filechooser"), page.click("#photo-change")]);
    await page.waitForSelector("#photo-picture", { state: "hidden" });
  });
}

test("the presets say what they do, and Custom appears for other settings", async ({ editor, page }) => {
  await editor.enableExpert();
  const segments = page.locator("#preset span").filter({ visible: true });
  const custom = page.locator("input[name='preset'][value='custom']");
  await expect(segments).toHaveText(["Sculpt", "Research paper"]);
  assert.match(await page.innerText("#preset-help"), /exactly where you put it/);
  await editor.choosePreset("paper");
  assert.match(await page.innerText("#preset-help"), /two random fixed points/);
  await editor.reveal("#edit-mirror");
  await page.locator("#edit-mirror").click();
  await expect(segments).toHaveText(["Sculpt", "Research paper", "Custom"]);
  assert.ok(await custom.isChecked());
  assert.ok(await custom.isDisabled(), "Custom can be chosen");
  assert.match(await page.innerText("#preset-help"), /own choices/);
  await editor.choosePreset("sculpt");
  await expect(segments).toHaveText(["Sculpt", "Research paper"]);
  assert.ok(!(await custom.isChecked()));
});

for (const [size, panel_px] of [[[1280, 720], 320], [[720, 450], 280]]) {
  test(`segments of a row have the same height and one line in either language: ${size.join(" × ")}`, async ({ open }) => {
    const visitor = await open({ viewport: { width: size[0], height: size[1] } });
    const { page } = visitor;
    await visitor.openFace();
    assert.equal((await page.locator("#panel").boundingBox()).width, panel_px);
    await visitor.enableExpert();
    await visitor.reveal("#edit-mirror");
    await page.locator("#edit-mirror").click();
    for (const language of ["en", "pt"]) {
      await visitor.setLanguage(language);
      for (const tab of ["shape", "view", "export"]) {
        await page.click(`#tab-${tab}`);
        const heights = await page.locator(".choice-options:not(.icons) span").filter({ visible: true }).evaluateAll((all) => all.map((span) => span.offsetHeight));
        assert.deepEqual([...new Set(heights)], [32], `${language}, ${tab}`);
        const wide = await page.locator(".choice-options").evaluateAll((all) => all.filter((row) => row.scrollWidth > row.clientWidth).map(({ id }) => id));
        assert.deepEqual(wide, [], `${language}, ${tab}`);
      }
    }
  });
}

for (const [width, height] of [[1280, 720], [720, 450], [844, 390], [360, 640]]) {
  test(`the list of keys is not cut, starts at its top and can be closed: ${width} × ${height}`, async ({ open }) => {
    const visitor = await open({ viewport: { width, height } });
    const { page } = visitor;
    await visitor.openFace();
    for (const language of ["en", "pt"]) {
      await visitor.setLanguage(language);
      for (const dialog of ["keys", "credits"]) {
        await page.dispatchEvent(`[data-action='open-${dialog}']`, "click");
        await expect(page.locator(`#${dialog}`)).toBeInViewport({ ratio: 1 });
        const { top, wider, higher } = await page.locator(`#${dialog}`).evaluate((dialog) => ({
          top: dialog.scrollTop,
          wider: dialog.scrollWidth - dialog.clientWidth,
          higher: dialog.scrollHeight - dialog.clientHeight,
        }));
        assert.deepEqual([top, wider], [0, 0]);
        if (height === 720) assert.equal(higher, 0, "the dialog scrolls");
        await expectInReach(page.locator(`[data-action='close-${dialog}']`));
        await page.click(`[data-action='close-${dialog}']`);
      }
    }
  });
}

test("hints say tap on touch devices and click otherwise; language and theme are available on both", async ({ open, editor }) => {
  const texts = async ({ page }) => `${await page.textContent("#welcome-title")} ${await page.textContent("#selection-help")}`;
  const phone = await open(PHONE);
  const { page } = phone;
  await phone.openFace();
  const byFinger = await texts(phone);
  assert.match(byFinger, /Choose or take a photo of a face.*Tap again/);
  assert.doesNotMatch(byFinger, /\b(drop|click)\b/i);
  assert.match(await texts(editor), /Drop a photo of a face.*Click again/);
  await page.locator("#language").scrollIntoViewIfNeeded();
  await page.selectOption("#language", "pt");
  assert.equal(await page.innerText("#tab-export"), "Exportar");
  const before = await page.getAttribute("html", "data-theme");
  await page.click("#theme");
  assert.notEqual(await page.getAttribute("html", "data-theme"), before);
});

test("the first steps show no jargon such as landmarks, their count or requests", async ({ open }) => {
  const JARGON = /landmark|request|0–467|0 to 467|\b468\b|requisi/i;
  for (const locale of ["en-GB", "pt-BR"]) {
    const visitor = await open({ locale });
    const { page } = visitor;
    await visitor.untilLoaded();
    assert.doesNotMatch(await page.innerText("body"), JARGON);
    assert.doesNotMatch(await page.textContent("#progress"), JARGON);
    await visitor.openFace();
    await visitor.setSlider("nose-width", 2);
    await visitor.unfold("section-photo");
    assert.doesNotMatch(await page.innerText("body"), JARGON);
  }
});

/**
 * Asserts that an element is completely in the window and can be clicked at its centre.
 *
 * @param {import("@playwright/test").Locator} element
 */
async function expectInReach(element) {
  await expect(element).toBeInViewport({ ratio: 1 });
  await element.click({ trial: true });
}

/** Number of colours of the thumbnail. */
function colours(page) {
  return page.locator("#photo-thumbnail").evaluate((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
}
