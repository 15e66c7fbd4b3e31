import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { variants, test } from "./fixtures.mjs";
import { faceless } from "./pictures.mjs";
import { DIST } from "./server.mjs";

/** Files that the worker requires. */
const WORKER_FILES = ["assets/face_detector.onnx", "assets/face_landmarks_attention.onnx", "wasm/rosto-vision-web_bg.wasm"];

for (const [file, tag] of variants(WORKER_FILES)) {
  test(`a ${path.extname(file)} with a flipped bit is not used (${path.basename(file)}), and the work stays`, { tag }, async ({ visitor, page, server }) => {
    await visitor.dropSample();
    await visitor.move("nose tip", "z", 7);
    const work = await visitor.meshJson("mm");

    const requests = await damage(server, file);
    const [dying] = page.workers();
    const next = page.waitForEvent("worker");
    await dying.evaluate(() => self.close()).catch(() => {});
    await next;
    await visitor.drop(faceless(), "next.png");
    const { code, text } = await visitor.notice();
    assert.equal(code, "not-as-built");
    assert.match(text, /failed its integrity check.*Reload the page.*your work is still here/s);
    assert.ok(requests.length >= 2, "the file was not requested again");
    await visitor.setLanguage("pt");
    assert.match((await visitor.notice()).text, /não passou na verificação de integridade.*Recarregue/s);
    await visitor.setLanguage("en");

    server.intercept();
    assert.deepEqual(await visitor.meshJson("mm"), work);
    await visitor.dropSample();
    await page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
  });
}

for (const [file, tag] of variants(["wasm/rosto-studio-web_bg.wasm", "integrity.json"])) {
  test(`a first visit with a damaged ${path.basename(file)} shows the right error`, { tag }, async ({ open, server }) => {
    await damage(server, file);
    const visitor = await open();
    assert.equal((await visitor.notice()).code, "not-as-built");
    server.intercept();
    await visitor.page.reload();
    await visitor.page.waitForSelector("body[data-host='open']");
    assert.ok(await visitor.page.isHidden("#notice"));
  });
}

test("after one damaged response the file is requested again without a notice", async ({ open, server }) => {
  const requests = await damage(server, WORKER_FILES[0], 1);
  const visitor = await open();
  await visitor.dropSample();
  assert.ok(requests.length >= 2);
  assert.ok(await visitor.page.isHidden("#notice"));
});

/**
 * Makes the server flip one bit of a file in the first `times` responses.
 *
 * @returns {Promise<string[]>} one entry per request
 */
async function damage(server, file, times = Infinity) {
  const bytes = await readFile(path.join(DIST, file));
  // In a module's data, a network's weights, or a hash of the list, where only the integrity check detects it.
  const place = file.endsWith(".json") ? bytes.indexOf("sha256-") + 9 : bytes.length - 2000;
  bytes[place] ^= 1;
  const type = file.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
  const requests = [];
  server.intercept((name, response) => {
    if (name !== file) return false;
    requests.push(name);
    if (requests.length > times) return false;
    response.writeHead(200, { "content-type": type }).end(bytes);
    return true;
  });
  return requests;
}
