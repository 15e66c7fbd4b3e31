import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { INSECURE_HOST } from "./browser.mjs";
import { variants, test } from "./fixtures.mjs";
import { delayFile } from "./delayed-file.mjs";

/** Responses that leave the page without its script. */
const FAULTS = [
  { what: "is not found", answer: { status: 404 } },
  { what: "is refused", answer: { status: 500 } },
  { what: "is a foreign page", answer: { status: 200, contentType: "text/html", body: "<p>Log in" } },
  { what: "is not the built one", answer: { status: 200, contentType: "text/javascript", body: "document.body.remove()" } },
];

for (const [{ what, answer }, tag] of variants(FAULTS)) {
  test(`if the page's script ${what}, the page shows a notice in both languages and can be reloaded`, { tag }, async ({ open }) => {
    const visitor = await open({ before: (context) => context.route("**/page.js", (route) => route.fulfill(answer)) });
    const { page } = visitor;
    await page.waitForSelector("#not-started");
    const text = await page.innerText("#not-started");
    assert.match(text, /Part of the page didn’t load/);
    assert.match(text, /Parte da página não carregou/);

    await page.context().unroute("**/page.js");
    await page.click("#start-again");
    await page.waitForSelector("body[data-host='open']");
    assert.ok(await page.isHidden("#not-started"));
  });
}

test("over plain HTTP, the page says that it needs HTTPS, at the start and for a photo and the camera", { tag: "@usual" }, async ({ open, server }) => {
  const visitor = await open({ url: server.url.replace("127.0.0.1", INSECURE_HOST) });
  const { page } = visitor;
  await page.waitForSelector("#notice[data-code='needs-https']");
  assert.match((await visitor.notice()).text, /^This page needs HTTPS\s+.*https:\/\//);
  for (const action of ["sample", "camera", "live-preview"]) {
    await page.keyboard.press("Escape");
    await page.waitForSelector("#notice", { state: "hidden" });
    await page.click(`#welcome [data-action='${action}']`);
    assert.equal((await visitor.notice()).code, "needs-https", action);
    assert.ok(await page.isVisible("#welcome"));
  }
});

test("without the words of its language, the page is in English, and the language menu too", async ({ open }) => {
  const visitor = await open({ locale: "pt-BR", before: (context) => context.route("**/pt-*.js", (route) => route.abort()) });
  const { page } = visitor;
  await page.waitForSelector("body[data-host='open']");
  assert.equal(await page.innerText("#welcome-title"), "Drop a photo of a face");
  await page.selectOption("#language", "pt");
  await expect(page.locator("#language")).toHaveValue("en");
  assert.ok(await page.isHidden("#notice"));
});

test("a browser gets the first of its languages that the page has", { tag: "@usual" }, async ({ open }) => {
  const visitor = await open({ scripts: [`Object.defineProperty(navigator, "languages", { value: ["fr-FR", "pt-PT", "en"] })`] });
  await visitor.untilInteractive();
  assert.equal(await visitor.page.getAttribute("html", "lang"), "pt-BR");
});

test("the page shows from its first paint that it is loading, and offers nothing that cannot be used yet", { tag: "@usual" }, async ({ open }) => {
  const [script, module] = [delayFile("**/page.js"), delayFile("**/*.wasm")];
  const before = async (context) => {
    await script.before(context);
    await module.before(context);
  };
  const visitor = await open({ before, waitUntil: "commit", reducedMotion: "no-preference" });
  const { page } = visitor;
  await page.waitForSelector(".loading");
  assert.equal(await page.innerText("#loading"), "Loading… · Carregando…");
  const movement = () => page.locator(".loading progress").evaluate((bar) => getComputedStyle(bar).animationName);
  assert.equal(await movement(), "wait");
  await page.emulateMedia({ reducedMotion: "reduce" });
  assert.equal(await movement(), "none");
  const usable = page.locator(":is(button, a, input, select, summary, [role=button]):visible:not([inert] *)");
  assert.deepEqual(await usable.allInnerTexts(), []);

  script.deliver();
  await visitor.untilInteractive();
  assert.equal(await page.innerText("#loading"), "Loading…");
  for (const button of ["#welcome [data-action='choose']", "#theme"]) await page.click(button, { trial: true });
  module.deliver();
  await page.waitForSelector("body[data-host='open']");
  assert.ok(await page.isHidden(".loading"));
});

test("without scripts, the page says that it did not start", { tag: "@usual" }, async ({ open }) => {
  const { page } = await open({ javaScriptEnabled: false });
  assert.match(await page.innerText("#not-started"), /Part of the page didn’t load/);
  assert.ok(await page.isHidden(".loading"));
});

test("a notice appears while modules do not arrive, and disappears when they do", async ({ open }) => {
  const { before, deliver } = delayFile("**/page.js");
  /** @type {Promise<void>} */
  let arrived;
  const page = await new Promise((show) => {
    const showing = async (context) => {
      await before(context);
      context.once("page", show);
    };
    arrived = open({ hasClock: true, before: showing });
  });
  await page.waitForSelector("#not-started", { state: "attached" });
  assert.ok(await page.isHidden("#not-started"));
  await page.clock.fastForward(20_000);
  await page.waitForSelector("#not-started");
  deliver();
  await arrived;
  await page.waitForSelector("#not-started", { state: "hidden" });
});

for (const [what, block] of /** @type {const} */ ([["cannot be read", blockStorage], ["is full", fillStorage]])) {
  test(`with storage that ${what} the page works, without remembering choices`, async ({ open }) => {
    const visitor = await open({ colorScheme: "light", scripts: [block] });
    const { page } = visitor;
    await page.waitForSelector("body[data-host='open']");
    await page.selectOption("#language", "pt");
    assert.equal(await page.innerText("#welcome-title"), "Solte aqui a foto de um rosto");
    await page.click("#theme");
    assert.equal(await page.getAttribute("html", "data-theme"), "dark");
    await page.click("#theme");
    assert.equal(await page.getAttribute("html", "data-theme"), "light");
    await visitor.dropSample();

    await page.reload();
    await page.waitForSelector("body[data-host='open']");
    assert.equal(await page.innerText("#welcome-title"), "Drop a photo of a face");
  });
}

for (const [{ drawn, needs, file, isByItself }, tag] of variants([
  { drawn: "WebGPU", needs: "gpu", file: "**/rosto-studio-web_bg.wasm", isByItself: false },
  { drawn: "WebGPU", needs: "gpu", file: "**/rosto-studio-web_bg.wasm", isByItself: true },
  { drawn: "WebGL2", needs: "webgl", file: "**/rosto-studio-webgl_bg.wasm", isByItself: false },
])) {
  const when = isByItself ? "the browser is online again" : "the user asks for it";
  test(`a module for ${drawn} that did not load is loaded when ${when}`, { tag: [...tag, `@${needs}`] }, async ({ open }) => {
    const visitor = await open({ before: (context) => context.route(file, (route) => route.abort()) });
    const { page } = visitor;
    assert.equal((await visitor.notice()).code, "not-loaded");
    assert.ok(await page.isHidden(".loading"));
    await page.click("#notice-retry");
    await page.waitForSelector("#notice-retry");
    await page.context().unroute(file);
    await (isByItself ? page.evaluate(() => dispatchEvent(new Event("online"))) : page.click("#notice-retry"));
    await page.waitForSelector("body[data-host='open']");
    assert.ok(await page.isHidden("#notice"));
    await visitor.openFace();
  });
}

for (const status of [404, "unreachable"]) {
  test(`if the sample is ${status}, a notice appears and a retry works`, async ({ open }) => {
    const visitor = await open({
      before: (context) => context.route("**/sample.png", (route) => (status === "unreachable" ? route.abort() : route.fulfill({ status }))),
    });
    const { page } = visitor;
    await page.click("#welcome [data-action='sample']");
    assert.equal((await visitor.notice()).code, "not-loaded");
    await page.context().unroute("**/sample.png");
    await page.click("#welcome [data-action='sample']");
    await visitor.untilFace();
  });
}

/** Runs in the page before its own scripts, as does the next function. */
function blockStorage() {
  Object.defineProperty(window, "localStorage", {
    get: () => {
      throw new DOMException("denied", "SecurityError");
    },
  });
}

function fillStorage() {
  Storage.prototype.setItem = () => {
    throw new DOMException("full", "QuotaExceededError");
  };
}
