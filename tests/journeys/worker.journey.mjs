import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { journey } from "./journey.mjs";
import { colourCount } from "./pixels.mjs";
import { faceless } from "./pictures.mjs";
import { SAMPLE } from "./visitor.mjs";

const WORKER_MODULE = "**/rosto-vision-web_bg.wasm";

journey("the page draws and answers before the worker's module has arrived", async (open) => {
  let deliver = () => {};
  const held = new Promise((resolve) => (deliver = resolve));
  const visitor = await open({
    before: (context) =>
      context.route(WORKER_MODULE, async (route) => {
        await held;
        await route.continue();
      }),
  });
  await visitor.page.waitForSelector("body[data-bench='open']");
  assert.ok(colourCount(await visitor.view()) > 4, "the canonical face is not drawn");
  await visitor.page.selectOption("#language", "pt");
  assert.equal(await visitor.page.innerText("#welcome-title"), "Solte aqui a foto de um rosto");
  await visitor.page.selectOption("#language", "en");
  await visitor.drop(await readFile(SAMPLE), "portrait.png");
  await visitor.page.waitForSelector("#progress-title:has-text('Loading the face networks')");
  deliver();
  await visitor.untilFace();
});

journey("a worker that dies is started again, and the work on screen stays", async (open) => {
  const visitor = await open();
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 7);
  const work = await visitor.meshJson("mm");

  const [dying] = visitor.page.workers();
  const next = visitor.page.waitForEvent("worker");
  await dying.evaluate(() => self.close()).catch(() => {});
  await next;
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
  await visitor.page.waitForFunction(() => document.querySelectorAll("#history li").length === 0);
});

journey("a photo that takes the worker down leaves the work and a message", async (open) => {
  const visitor = await open();
  await visitor.dropSample();
  await visitor.findLandmark("nose tip");
  await visitor.offset("z", 7);
  const work = await visitor.meshJson("mm");

  const [dying] = visitor.page.workers();
  await dying.evaluate(() => {
    const tell = self.postMessage.bind(self);
    self.postMessage = (message, transfer) => {
      if (message.type === "found") throw new WebAssembly.RuntimeError("unreachable");
      tell(message, transfer);
    };
  });
  await visitor.drop(faceless(), "trap.png");
  assert.equal((await visitor.notice()).code, "worker-died");
  assert.deepEqual(await visitor.meshJson("mm"), work);
  await visitor.dropSample();
});
