import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { launch } from "../browser.mjs";

/** WebDriver's names of keys, for Playwright. */
const KEYS = { "\uE004": "Tab", "\uE007": "Enter" };

/**
 * Chromium, kept from WebGPU.
 *
 * @returns {Promise<import("./hand.mjs").Driver>}
 */
export async function chromium() {
  const downloads = await mkdtemp(path.join(tmpdir(), "rosto-chromium-"));
  const browser = await launch({ gpu: "webgl" });
  const page = await browser.newPage({ viewport: { width: 1024, height: 640 }, acceptDownloads: true });
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) => errors.push(String(error)));
  // Messages of the browser itself have no arguments, and differ between versions.
  page.on("console", (message) => message.type() === "error" && message.args().length > 0 && errors.push(message.text()));
  page.on("download", (download) => download.saveAs(path.join(downloads, download.suggestedFilename())));
  return {
    engine: "Chromium",
    version: browser.version(),
    downloads,
    open: async (url) => void (await page.goto(url)),
    reload: async () => void (await page.reload()),
    evaluate: (script) => page.evaluate(`(async () => { ${script} })()`),
    act: async (sources) => {
      for (const { actions } of /** @type {any[]} */ (sources)) for (const action of actions) await one(page, action);
    },
    screenshot: () => page.screenshot(),
    errors: async () => errors,
    close: async () => {
      await browser.close();
      await rm(downloads, { recursive: true, force: true });
    },
  };
}

/** @param {import("playwright-core").Page} page @param {any} action */
async function one({ mouse, keyboard }, { type, x, y, value }) {
  if (type === "pointerMove") return mouse.move(x, y);
  if (type === "pointerDown") return mouse.down();
  if (type === "pointerUp") return mouse.up();
  if (type === "keyDown") return keyboard.down(KEYS[value] ?? value);
  return keyboard.up(KEYS[value] ?? value);
}
