import assert from "node:assert/strict";
import { mkdir, readFile, truncate, writeFile } from "node:fs/promises";
import { test } from "./fixtures.mjs";
import { heic, text } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

/** Maximum sizes of a photo, and of a GLB or project. */
const [MAX_PHOTO_BYTES, MAX_SAVED_BYTES] = [40_000_000, 400_000_000];

test("the first valid file of several is opened, and a notice says so", async ({ visitor, page }) => {
  await visitor.untilInteractive();
  const portrait = await readFile(SAMPLE);
  const notes = { bytes: text(), name: "notes.txt", type: "text/plain" };
  const phone = { bytes: heic(), name: "IMG_0001.HEIC", type: "image/heic" };
  const photo = { bytes: portrait, name: "me & you.png", type: "image/png" };
  for (const way of /** @type {const} */ (["drop", "paste"])) {
    await bring(page, way, [notes, phone, photo]);
    await visitor.untilFace();
    assert.match((await visitor.notice()).text, /^Opened one of 3 files\s+me & you\.png is open\. To open several files, choose only photos\.$/);
    await page.selectOption("#language", "pt");
    assert.match((await visitor.notice()).text, /^Um de 3 arquivos foi aberto/);
    await page.selectOption("#language", "en");
    await bring(page, way, [photo]);
    await visitor.untilFace();
    await page.waitForSelector("#notice", { state: "hidden" });
  }

  // The MIME type counts if the name has no extension. A file that cannot be opened shows an error.
  await bring(page, "drop", [notes, { ...photo, name: "portrait" }]);
  await visitor.untilFace();
  assert.match((await visitor.notice()).text, /Opened one of 2 files/);
  await bring(page, "drop", [notes, phone]);
  await page.waitForSelector("#notice[data-code='unsupported-format']");
});

test("a dropped URL, text or HTML shows a notice, and text fields still accept text", async ({ visitor, page }) => {
  await visitor.dropSample();
  const words = [
    { "text/uri-list": "https://example.com/me.jpg", "text/plain": "https://example.com/me.jpg" },
    { "text/plain": "A face" },
    { "text/html": "<img src='https://example.com/me.jpg'>" },
  ];
  for (const data of words) {
    for (const way of /** @type {const} */ (["drop", "paste"])) {
      await page.keyboard.down("Control");
      await page.keyboard.down("v");
      await bring(page, way, [], data);
      await page.keyboard.up("v");
      await page.keyboard.up("Control");
      const { code, text } = await visitor.notice();
      assert.equal(code, "not-a-file");
      assert.match(text, /drop the picture itself/);
      assert.ok(await page.isHidden("#drop-veil"));
      await page.keyboard.press("Escape");
    }
  }
  await visitor.unfold("section-landmark");
  const isLeftAlone = await page.locator("#landmark-search").evaluate((field) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "nose tip");
    return field.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  });
  assert.ok(isLeftAlone);
  assert.ok(await page.isHidden("#notice"));
});

test("a middle drag turns the face and pastes nothing, and Ctrl V of text shows a notice", async ({ open }) => {
  const visitor = await open({ scripts: [recordMiddleButton], permissions: ["clipboard-read", "clipboard-write"] });
  const { page } = visitor;
  await visitor.openFace();
  await visitor.findLandmark("nose tip");
  const tip = await visitor.selectionPosition();
  await page.focus("#viewport");
  await page.mouse.move(tip.x, tip.y);
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(tip.x + 60, tip.y, { steps: 4 });
  await page.mouse.up({ button: "middle" });
  assert.ok(Math.abs((await visitor.selectionPosition()).x - tip.x) > 5, "the face was not turned");
  // On Linux, a release that is not prevented pastes the selected text.
  assert.deepEqual(await page.evaluate(() => window.middleButton), [["mousedown", true], ["mouseup", true], ["auxclick", true]]);
  await bring(page, "paste", [], { "text/plain": "selected elsewhere" });
  await visitor.frames(3);
  assert.ok(await page.isHidden("#notice"));

  await page.evaluate(() => navigator.clipboard.writeText("https://example.com/me.jpg"));
  await page.keyboard.press("Control+v");
  assert.equal((await visitor.notice()).code, "not-a-file");
});

test("the file choosers offer HEIC photos, which open where the browser decodes them", { tag: "@usual" }, async ({ visitor, page }) => {
  await visitor.untilInteractive();
  for (const id of ["photo-file", "further-files"]) {
    const accepted = (await page.getAttribute(`#${id}`, "accept")).split(",");
    for (const one of ["image/heic", "image/heif", ".heic", ".heif"]) assert.ok(accepted.includes(one), `${id}: ${one}`);
  }
  await page.setInputFiles("#photo-file", { name: "IMG_0001.HEIC", mimeType: "image/heic", buffer: heic() });
  const { code, text } = await visitor.notice();
  assert.equal(code, "unsupported-format");
  assert.match(text, /Most Compatible/);
});

test("a dropped folder shows a notice", async ({ visitor }, testInfo) => {
  await visitor.untilInteractive();
  const photos = testInfo.outputPath("photos.png");
  await mkdir(photos);
  await dropFromDesktop(visitor.page, [photos]);
  assert.equal((await visitor.notice()).code, "folder");
  await dropFromDesktop(visitor.page, [photos, SAMPLE]);
  await visitor.untilFace();
  await visitor.page.waitForSelector("#notice", { state: "hidden" });
});

test("a file of gigabytes is reported as too large, at the worker's limit", async ({ visitor, page }, testInfo) => {
  await visitor.untilInteractive();
  for (const [bytes, code, start] of /** @type {const} */ ([
    [3 * 2 ** 30, "too-many-bytes", ""],
    [MAX_PHOTO_BYTES, "not-a-picture", ""],
    [MAX_PHOTO_BYTES + 1, "too-many-bytes", ""],
    [MAX_PHOTO_BYTES + 1, "damaged-glb", "glTF"],
    [MAX_SAVED_BYTES + 1, "too-many-bytes", "glTF"],
  ])) {
    const name = testInfo.outputPath(`${start}${bytes}.jpg`);
    // A sparse file needs no disk space.
    await writeFile(name, start);
    await truncate(name, bytes);
    await page.setInputFiles("#photo-file", name);
    await page.waitForSelector(`#notice[data-code='${code}']`);
    await page.waitForSelector("#progress", { state: "hidden" });
  }
  await visitor.dropSample();
});

/** Runs in the page before its own scripts: records the middle button's events on the stage, and whether they are prevented. */
function recordMiddleButton() {
  window.middleButton = [];
  for (const type of ["mousedown", "mouseup", "auxclick"]) {
    addEventListener(type, (event) => event.button === 1 && window.middleButton.push([type, event.defaultPrevented]));
  }
}

/** Drops or pastes files, or data by MIME type. */
async function bring(page, way, files, data = {}) {
  const parts = files.map(({ bytes, ...named }) => ({ bytes: new Uint8Array(bytes), ...named }));
  await page.evaluate(
    ({ way, parts, data }) => {
      const transfer = new DataTransfer();
      for (const { bytes, name, type } of parts) transfer.items.add(new File([bytes], name, { type }));
      for (const [type, text] of Object.entries(data)) transfer.setData(type, text);
      const options = { bubbles: true, cancelable: true };
      const stage = document.getElementById("stage");
      if (way === "paste") return stage.dispatchEvent(new ClipboardEvent("paste", { ...options, clipboardData: transfer }));
      stage.dispatchEvent(new DragEvent("dragover", { ...options, dataTransfer: transfer }));
      stage.dispatchEvent(new DragEvent("drop", { ...options, dataTransfer: transfer }));
    },
    { way, parts, data },
  );
}

/** Drops files from disk, as a file manager does. */
async function dropFromDesktop(page, files) {
  const browser = await page.context().newCDPSession(page);
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of /** @type {const} */ (["dragEnter", "dragOver", "drop"])) {
    await browser.send("Input.dispatchDragEvent", { type, x: 200, y: 200, data });
  }
  await browser.detach();
}
