import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { alike, test } from "./fixtures.mjs";
import { faceless } from "./pictures.mjs";
import { DIST } from "./server.mjs";

/** What the worker cannot do without. */
const OF_THE_WORKER = ["assets/face_detector.onnx", "assets/face_landmarks_attention.onnx", "wasm/rosto-vision-web_bg.wasm"];

for (const [file, tag] of alike(OF_THE_WORKER)) {
  test(`a ${path.extname(file)} of which one bit is another is not used (${path.basename(file)}), and nothing is lost`, { tag }, async ({ visitor, page, server }) => {
    await visitor.dropSample();
    await visitor.move("nose tip", "z", 7);
    const work = await visitor.meshJson("mm");

    const asked = await damage(server, file);
    const [dying] = page.workers();
    const next = page.waitForEvent("worker");
    await dying.evaluate(() => self.close()).catch(() => {});
    await next;
    await visitor.drop(faceless(), "next.png");
    const { code, text } = await visitor.notice();
    assert.equal(code, "not-as-built");
    assert.match(text, /failed its integrity check.*Reload the page.*your work is still here/s);
    assert.ok(asked.length >= 2, "it was not asked for once more");
    await visitor.speak("pt");
    assert.match((await visitor.notice()).text, /não passou na verificação de integridade.*Recarregue/s);
    await visitor.speak("en");
    assert.deepEqual(await visitor.meshJson("mm"), work);

    server.disturb();
    await visitor.dropSample();
    await page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
  });
}

for (const [file, tag] of alike(["wasm/rosto-studio-web_bg.wasm", "integrity.json"])) {
  test(`a visitor's first page with a damaged ${path.basename(file)} says what is the matter`, { tag }, async ({ open, server }) => {
    await damage(server, file);
    const visitor = await open();
    assert.equal((await visitor.notice()).code, "not-as-built");
    server.disturb();
    await visitor.page.reload();
    await visitor.page.waitForSelector("body[data-host='open']");
    assert.ok(await visitor.page.isHidden("#notice"));
  });
}

test("one damaged answer is asked for again, and nobody notices", async ({ open, server }) => {
  const asked = await damage(server, OF_THE_WORKER[0], 1);
  const visitor = await open();
  await visitor.dropSample();
  assert.ok(asked.length >= 2);
  assert.ok(await visitor.page.isHidden("#notice"));
});

/** Has the server answer `times` times with a file of which one bit is another. @returns {Promise<string[]>} an entry for each request */
async function damage(server, file, times = Infinity) {
  const bytes = await readFile(path.join(DIST, file));
  // In the data of a module and among the weights of a network, where nothing else would notice; in the list a letter of a hash.
  const place = file.endsWith(".json") ? bytes.indexOf("sha256-") + 9 : bytes.length - 2000;
  bytes[place] ^= 1;
  const type = file.endsWith(".wasm") ? "application/wasm" : "application/octet-stream";
  const asked = [];
  server.disturb((name, response) => {
    if (name !== file) return false;
    asked.push(name);
    if (asked.length > times) return false;
    response.writeHead(200, { "content-type": type }).end(bytes);
    return true;
  });
  return asked;
}
