import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { expect } from "@playwright/test";
import { PNG } from "pngjs";
import { partsOfGlb } from "./changed-files.mjs";
import { filesByCommandLine } from "./command-line.mjs";
import { test } from "./fixtures.mjs";
import { PAGE_OPTIONS, openAsCommandLine, storedFiles } from "./same-face.mjs";
import { validateGlb } from "./validate-glb.mjs";
import { SAMPLE } from "./visitor.mjs";

test.use({ visit: { expert: true } });

/** Density, vertices and triangles of the closed face. */
const DENSITIES = [[0, 468, 898], [2, 7257, 14368]];

test("a GLB passes the validator, and the page reports it before the download", { tag: "@usual" }, async ({ editor, page }) => {
  await editor.untilLoaded();
  await editor.move("nose tip", "z", 5);
  await editor.unfold("section-export");
  for (const [density, vertices, triangles] of DENSITIES) {
    await page.selectOption("#export-density", String(density));
    assert.equal(await page.inputValue("#density"), String(density));
    await page.click("[data-action='check-glb']");
    await page.waitForSelector("#verdict[data-tone='success']");
    const verdict = await page.innerText("#verdict");
    const { name, json, bytes } = await downloadGlb(editor);
    assert.equal(name, density === 2 ? "portrait.glb" : `portrait-${vertices}.glb`);
    const size = bytes < 1e6 ? `${Math.round(bytes / 1000).toLocaleString("en-GB")} KB` : `${(bytes / 1e6).toFixed(1)} MB`;
    assert.equal(verdict, `${name}, ${size}: valid glTF 2.0, 0 errors, 0 warnings, 0 notes`);
    const [{ attributes, indices }] = json.meshes[0].primitives;
    assert.equal(json.accessors[attributes.POSITION].count, vertices);
    assert.equal(json.accessors[indices].count, 3 * triangles);
  }
});

test("the print measurements match the command line, and the STL matches byte for byte", async ({ visitor, page }) => {
  await openAsCommandLine(visitor);
  await visitor.reveal("#print-facts");
  for (const [body, length] of [["thickness:2", "2"], ["flat", "27"], ["surface"]]) {
    const [solid] = body.split(":");
    await page.check(`input[name="solid"][value="${solid}"]`, { force: true });
    const shown = page.locator("#print .slider:visible .number-field");
    assert.deepEqual(await shown.evaluateAll((fields) => fields.map(({ value }) => value)), length ? [length, "80"] : []);
    const height = length ? ["--height-mm", "80"] : [];
    const { files, log } = await filesByCommandLine(SAMPLE, "face.stl", [...PAGE_OPTIONS, "--solid", body, ...height]);
    const measures = await measured(page);
    assert.deepEqual(measures, measuresIn(log), body);
    assert.equal(measures.length > 0, solid !== "surface");
    assert.ok((await visitor.download("download-stl")).equals(files.get("face.stl")), `another STL: ${body}`);
  }
});

test("a body that cannot be printed is refused with an allowed length", async ({ editor, page }) => {
  await editor.reveal("#print-facts");
  // Without densification, so that thick walls fit a small face.
  await page.selectOption("#export-density", "0");
  let downloads = 0;
  page.on("download", () => (downloads += 1));
  const refusal = page.locator("#print-error");
  const thickness = page.locator("#solid-thickness-mm .number-field");
  await thickness.fill("0.1");
  await expect(thickness).toHaveAttribute("aria-invalid", "true");
  await expect(thickness).toHaveAttribute("title", "From 0.4 to 50.");
  await thickness.press("Tab");
  await expect(thickness).toHaveValue("2");
  await page.evaluate(refuseWalls, { most_mm: 11.38 });
  await thickness.fill("12");
  await expect(refusal).toHaveText("A wall this thick would pass through itself. Use at most 11.3 mm, or a flat back.");
  await page.click("[data-action='download-3mf']");
  assert.equal(downloads, 0);
  await thickness.fill("11.3");
  await expect(refusal).toBeHidden();
  assert.ok((await measured(page)).length > 0);
  assert.ok((await editor.download("download-stl")).length > 84);

  await page.check("input[name='solid'][value='surface']", { force: true });
  await page.click("[data-action='download-3mf']");
  await expect(refusal).toHaveText("A surface can’t be saved as 3MF. Choose a mask or a flat back, or save it as STL.");
  await page.check("input[name='solid'][value='thickness']", { force: true });
  await expect(refusal).toBeHidden();
  assert.equal(await thickness.inputValue(), "11.3", "the thickness was forgotten");
  assert.ok(await page.isHidden("#notice"));
});

test("browsers with the features can share the GLB, copy the picture and open AR", async ({ open }) => {
  const visitor = await open({ scripts: [installSharing] });
  const { page } = visitor;
  await visitor.openFace("ana");
  await visitor.unfold("section-export");
  await page.click("#share-glb");
  const shared = await passedOn(page, "sent");
  assert.deepEqual([shared.name, shared.type], ["ana.glb", "model/gltf-binary"]);
  assert.deepEqual(await validateGlb(shared.bytes), { clean: true, counts: "0/0/0/0", messages: [] });

  // The toast may disappear while the file is read.
  const toast = page.waitForSelector("#toast:not([hidden])").then((element) => element.innerText());
  await page.click("#copy-picture");
  const copied = await passedOn(page, "copied");
  const { width, height } = PNG.sync.read(Buffer.from(copied.bytes));
  const view = await page.locator("#viewport").evaluate(({ width, height }) => ({ width, height }));
  assert.deepEqual([copied.type, width, height], ["image/png", 2 * view.width, 2 * view.height]);
  assert.equal(await toast, "Picture copied to the clipboard");

  const link = page.locator("#ar-link");
  assert.deepEqual(await link.evaluate(({ rel, children }) => [rel, [...children].map(({ tagName }) => tagName)]), ["ar", ["IMG"]]);
  for (const _ of ["once", "again"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), link.click()]);
    assert.equal(download.suggestedFilename(), "ana.usdz");
    const usdz = storedFiles(await readFile(await download.path()));
    assert.deepEqual([...usdz.keys()], ["face.usda", "face.jpg"]);
    assert.match(usdz.get("face.usda")?.toString() ?? "", /^#usda 1\.0/);
  }
  await page.evaluate("refuses = true");
  await page.click("#copy-picture");
  assert.equal((await visitor.notice()).code, "not-copied");
  assert.equal((await Promise.all([page.waitForEvent("download"), page.click("#share-glb")]))[0].suggestedFilename(), "ana.glb");
});

test("without share, clipboard and AR support, their buttons are hidden", async ({ open }) => {
  const visitor = await open({ scripts: ["delete Navigator.prototype.canShare; delete window.ClipboardItem"] });
  await visitor.openFace();
  await visitor.unfold("section-export");
  for (const id of ["share-glb", "save-share", "copy-picture", "ar-link"]) assert.ok(await visitor.page.isHidden(`#${id}`), id);
});

/** Printed measurements on the page: mm, cm³ and g, and the rounding of folds if there is any. */
async function measured(page) {
  await page.waitForSelector("#print-facts:not([data-stale])", { state: "attached" });
  const texts = await page.locator("#print-facts dd").allInnerTexts();
  return texts.map((text) => text.replaceAll(",", ""));
}

/** The same measurements from the command line's output. @param {string} log */
function measuresIn(log) {
  const [, volume, size, mass, thinnest] = /a body of ([\d.]+) cm³, (.*) mm, (\d+) g .*; ([\d.]+) mm/.exec(log) ?? [];
  const [, rounded] = /smoothed by up to ([\d.]+) mm/.exec(log) ?? [];
  if (!volume) return [];
  return [`${size} mm`, `${volume} cm³`, `${mass} g`, `${thinnest} mm`, ...(Number(rounded) > 0 ? [`${rounded} mm`] : [])];
}

/** Runs in the page: rejects walls thicker than a limit, in place of the worker. @param {{ most_mm: number }} limit */
function refuseWalls({ most_mm }) {
  const post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (message, ...rest) {
    const isThick = Number(/** @type {HTMLInputElement} */ (document.querySelector("#solid-thickness-mm .number-field")).value) > most_mm;
    if (!isThick || !["print", "write"].includes(message.type)) return post.call(this, message, ...rest);
    const error = { code: "too-thick", message: "too thick", hint: "", maxMm: most_mm };
    const reply = new MessageEvent("message", { data: { type: "failed", id: message.id, error } });
    setTimeout(() => this.dispatchEvent(reply));
  };
}

/** Runs in the page before its own scripts: supports share, clipboard and AR, or refuses each. */
function installSharing() {
  const keep = async (/** @type {string} */ what, /** @type {Blob & { name?: string }} */ file) => {
    if (window["refuses"]) throw new DOMException("refused", "NotAllowedError");
    window[what] = { name: file.name, type: file.type, bytes: new Uint8Array(await file.arrayBuffer()) };
  };
  navigator.canShare = () => true;
  navigator.share = ({ files: [file] }) => keep("sent", file);
  navigator.clipboard.write = async ([item]) => keep("copied", await item.getType("image/png"));
  DOMTokenList.prototype.supports = (/** @type {string} */ token) => token === "ar";
}

/** Waits for the file that the page passed on. @param {import("@playwright/test").Page} page @param {string} what */
async function passedOn(page, what) {
  return (await page.waitForFunction((what) => window[what], what)).jsonValue();
}

/** Downloads the GLB, validates it and parses its JSON. */
async function downloadGlb(visitor) {
  const { name, bytes } = await visitor.save("download-glb");
  assert.deepEqual(await validateGlb(bytes), { clean: true, counts: "0/0/0/0", messages: [] });
  return { name, json: partsOfGlb(bytes).json, bytes: bytes.length };
}

test("a dense print is made without blocking the page, and can be cancelled", async ({ editor, page }) => {
  await editor.unfold("section-export");
  await page.selectOption("#export-density", "3");
  await editor.reveal("#print-facts");
  await page.evaluate(() => {
    globalThis.longest_ms = 0;
    new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) globalThis.longest_ms = Math.max(globalThis.longest_ms, duration);
    }).observe({ type: "longtask" });
  });
  const downloads = [];
  page.on("download", (download) => downloads.push(download.suggestedFilename()));
  await page.click("#download-stl");
  await expect(page.locator("#export-making-file")).toHaveText(/portrait-28881\.stl/);
  await page.click("#cancel-file");
  await page.waitForSelector("#export-making", { state: "hidden" });
  assert.deepEqual([downloads, await page.isHidden("#notice"), await page.isHidden("#print-error")], [[], true, true]);

  await page.selectOption("#export-density", "2");
  await page.evaluate(() => (globalThis.longest_ms = 0));
  const began_ms = Date.now();
  const { name } = await editor.save("download-stl");
  const took_ms = Date.now() - began_ms;
  assert.equal(name, "portrait.stl");
  assert.ok(await page.isHidden("#export-making"));
  const longest_ms = await page.evaluate(() => globalThis.longest_ms);
  // Relative, because a busy machine slows down both.
  assert.ok(longest_ms < took_ms / 4, `the page was blocked for ${longest_ms} of ${took_ms} ms`);
});
