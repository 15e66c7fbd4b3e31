import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { PNG } from "pngjs";
import { journey } from "./journey.mjs";
import { difference, differenceNear } from "./pixels.mjs";
import { SAMPLE } from "./visitor.mjs";

/** As in side-by-side.js: a share of the picture's height. */
const GAP = 0.008;

journey("before and after are the halves of one picture, and the view stays as it was", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.drop(await readFile(SAMPLE), "ana.png");
  await visitor.untilFace();
  const found = PNG.sync.read(await visitor.download("download-picture"));
  await visitor.findLandmark("nose tip");
  await visitor.offset("x", 12);
  const place = await visitor.onView(await visitor.selectedPlace());
  const edited = PNG.sync.read(await visitor.download("download-picture"));
  const before = await standing(visitor);
  const coming = page.waitForEvent("download");
  const pair = PNG.sync.read(await visitor.download("download-pair"));
  assert.equal((await coming).suggestedFilename(), "ana-before-after.png");
  const [left, right] = halves(pair);
  for (const [half, alone] of [[left, found], [right, edited]]) {
    assert.equal(difference(above(half), above(middleOf(alone, half.width))), 0, "a half is not the picture that is saved alone");
  }
  const nose = { x: left.width / 2 + 2 * (place.x - before.view.width / 2), y: 2 * place.y };
  assert.ok(differenceNear(left, right, nose, 60) > 0.2, "the halves show the same nose");
  assert.equal(differenceNear(left, right, { x: 40, y: 40 }, 30), 0, "they differ where nothing was edited");
  assert.ok(difference(below(left), below(middleOf(found, left.width))) > 0.005, "there is no caption");
  assertSame(await standing(visitor), before);
}, { needs: "eyes" });

journey("a picture of before and after that cannot be made says so and leaves the view as it was", async (open) => {
  const visitor = await open();
  const { page } = visitor;
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("x", 12);
  const before = await standing(visitor);
  await page.evaluate(refusePictures);
  await visitor.unfold("section-export");
  await page.click("[data-action='download-pair']");
  assert.equal((await visitor.notice()).code, "not-drawn");
  assertSame(await standing(visitor), before);
}, { needs: "eyes" });

journey("before and after are handed on where the browser can, and downloaded where it then will not", async (open) => {
  const visitor = await open({ before: (context) => context.addInitScript(sendFiles) });
  const { page } = visitor;
  await visitor.dropSample();
  await visitor.unfold("section-export");
  await page.click("[data-action='share-pair']");
  await page.waitForFunction(() => window["sent"].length === 1);
  const [sent] = await page.evaluate("sent");
  assert.deepEqual([sent.name, sent.type], ["portrait-before-after.png", "image/png"]);
  assert.ok(sent.bytes > 10_000, `${sent.bytes} bytes`);
  await page.evaluate("answer = 'NotAllowedError'");
  await visitor.download("share-pair");
  await page.evaluate("answer = 'AbortError'");
  await page.click("[data-action='share-pair']");
  await page.waitForFunction(() => window["sent"].length === 3);
  assert.ok(await page.isHidden("#notice"));
});

journey("a browser that hands nothing on has no button for it", async (open) => {
  const visitor = await open({ before: (context) => context.addInitScript("delete Navigator.prototype.canShare") });
  await visitor.dropSample();
  await visitor.unfold("section-export");
  assert.ok(await visitor.page.isHidden("[data-action='share-pair']"));
});

/** What making a picture must leave as it is. @param {import("./visitor.mjs").Visitor} visitor */
async function standing(visitor) {
  const mesh = await visitor.meshJson("mm");
  return { mesh, history: await visitor.history(), view: await visitor.view() };
}

/**
 * @param {Awaited<ReturnType<typeof standing>>} now
 * @param {Awaited<ReturnType<typeof standing>>} before
 */
function assertSame(now, before) {
  assert.deepEqual([now.mesh, now.history], [before.mesh, before.history]);
  assert.equal(difference(now.view, before.view), 0, "the view is not what it was");
}

/** The two pictures of one, without the gap between them. @param {PNG} pair */
function halves(pair) {
  const width = (pair.width - Math.round(GAP * pair.height)) / 2;
  return [cut(pair, 0, width), cut(pair, pair.width - width, width)];
}

/** As much of a picture's middle. @param {PNG} picture @param {number} width */
function middleOf(picture, width) {
  return cut(picture, (picture.width - width) / 2, width);
}

/** What is over the caption. @param {PNG} picture */
function above(picture) {
  return rows(picture, 0, Math.floor(0.92 * picture.height));
}

/** @param {PNG} picture */
function below(picture) {
  return rows(picture, Math.floor(0.92 * picture.height), picture.height);
}

/** @param {PNG} picture @param {number} from @param {number} to */
function rows({ width, data }, from, to) {
  return { width, height: to - from, data: data.subarray(4 * width * from, 4 * width * to) };
}

/** @param {PNG} picture @param {number} left @param {number} width */
function cut(picture, left, width) {
  const part = new PNG({ width, height: picture.height });
  PNG.bitblt(picture, part, left, 0, width, picture.height, 0, 0);
  return part;
}

/** Runs in the page: the second picture that is asked for is not drawn. */
async function refusePictures() {
  const { Studio } = await import(new URL("wasm/rosto-studio-web.js", document.baseURI).href);
  const snapshot = Studio.prototype.snapshot;
  let asked = 0;
  Studio.prototype.snapshot = function (...wishes) {
    asked += 1;
    if (asked % 2 === 0) throw Object.assign(new Error("refused"), { code: "not-drawn" });
    return snapshot.apply(this, wishes);
  };
}

/** Runs in the page before its own scripts: a browser that hands files on, or gives the answer that is told. */
function sendFiles() {
  window["sent"] = [];
  navigator.canShare = () => true;
  navigator.share = async ({ files: [{ name, type, size }] }) => {
    window["sent"].push({ name, type, bytes: size });
    if (window["answer"]) throw new DOMException("refused", window["answer"]);
  };
}
