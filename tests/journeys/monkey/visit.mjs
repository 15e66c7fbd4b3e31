import { readFile } from "node:fs/promises";
import path from "node:path";
import { launch } from "../browser.mjs";
import { SAMPLE, Visitor } from "../visitor.mjs";
import { letMonkeyIn } from "./page.mjs";

/** @typedef {import("./page.mjs").Seen} Seen */

/** The page draws a frame within this time. */
const FRAME_MS = 30_000;
/** Long enough for the slowest thing that one action waits for. */
const ACTION_MS = 90_000;
const OPENING_MS = 30_000;
/** Notices that ordinary use must never cause: they report that the page is at odds with itself. */
const INTERNAL = new Set(["internal", "other", "bad-vertex", "bad-choice", "no-selection"]);

/** One visit to the page, in a browser of its own. The first thing that is wrong ends it. */
export class Visit {
  /** What was downloaded, the newest of its kind, by extension. @type {Map<string, Buffer>} */
  downloads = new Map();
  isTouching = false;
  /** Actions done. */
  done = 0;
  /** @type {Error | undefined} */
  #fault;

  /** @param {string} url @param {string} film the file that the camera plays */
  static async start(url, film) {
    const browser = await launch({ film, seen: false });
    const before = (/** @type {import("@playwright/test").BrowserContext} */ context) => context.addInitScript(letMonkeyIn);
    const { page } = await Visitor.arrive(browser, url, { viewport: { width: 760, height: 480 }, hasTouch: true, before });
    const visit = new Visit(page, await page.context().newCDPSession(page));
    await visit.look();
    return visit;
  }

  /** @param {import("@playwright/test").Page} page @param {import("@playwright/test").CDPSession} input */
  constructor(page, input) {
    this.page = page;
    this.input = input;
    const fail = (/** @type {string} */ message, /** @type {unknown} */ cause) => {
      this.#fault ??= new Error(message, { cause });
    };
    page.removeAllListeners("filechooser");
    page.on("filechooser", (chooser) => chooser.setFiles(SAMPLE).catch(() => {}));
    page.on("pageerror", (error) => fail(`page error: ${error.message}`, error));
    page.on("crash", () => fail("the page's process died", undefined));
    // Messages of the browser itself have no arguments, and differ between versions.
    page.on("console", (message) => message.type() === "error" && message.args().length > 0 && fail(`console: ${message.text()}`, undefined));
    page.on("download", (download) => this.#keep(download));
  }

  /** Does something and looks at what came of it. @param {() => Promise<void>} act */
  async perform(act) {
    this.done += 1;
    try {
      await within(ACTION_MS, act(), "an action did not end");
      await this.look();
    } catch (error) {
      // The page's own error explains what the visitor ran into.
      throw this.#fault ?? error;
    }
    if (this.#fault) throw this.#fault;
  }

  /** Looks at the page after its next frames. */
  async look(frames = 1) {
    /** @type {Seen} */
    this.seen = await within(FRAME_MS, this.#settled(frames), "the page does not draw");
    if (INTERNAL.has(this.seen.error)) throw new Error(`notice ${this.seen.error}: ${this.seen.notice}`);
    return this.seen;
  }

  /** Presses a button wherever it is; returns whether it could be pressed. @param {string} selector @returns {Promise<boolean>} */
  press(selector) {
    return this.page.evaluate((selector) => window["monkey"].press(selector), selector);
  }

  /** Waits until no file is being opened. */
  async untilQuiet() {
    await this.look(3);
    await this.page.waitForFunction(() => !window["monkey"].look().busy, undefined, { timeout: OPENING_MS }).catch(() => {});
  }

  /** Resumes the stored work, if it is offered in time. @param {number} limit_ms @returns {Promise<boolean>} whether it was */
  async resume(limit_ms) {
    const offer = "#continue:not([hidden])";
    const isOffered = await this.page.waitForSelector(offer, { timeout: limit_ms, state: "attached" }).then(() => true, () => false);
    if (!isOffered) return false;
    await this.press(offer);
    await this.page.waitForSelector("body[data-state='face']", { timeout: OPENING_MS });
    await this.untilQuiet();
    return true;
  }

  async end() {
    await this.page.context().browser().close();
  }

  /** @param {number} frames @returns {Promise<Seen>} */
  async #settled(frames) {
    for (;;) {
      try {
        return await this.page.evaluate((frames) => window["monkey"].settle(frames), frames);
      } catch (error) {
        // The page was being left for its reloaded self.
        if (!/context was destroyed|navigation/i.test(String(error))) throw error;
        await this.page.waitForLoadState();
      }
    }
  }

  /** @param {import("@playwright/test").Download} download */
  async #keep(download) {
    // One that a reload breaks off never comes.
    const bytes = await download.path().then(readFile).catch(() => undefined);
    if (bytes) this.downloads.set(path.extname(download.suggestedFilename()).slice(1), bytes);
  }
}

/**
 * @template T
 * @param {number} limit_ms
 * @param {Promise<T>} work
 * @param {string} late
 * @returns {Promise<T>}
 */
async function within(limit_ms, work, late) {
  let timer;
  const limit = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`${late} within ${limit_ms / 1000} s`)), limit_ms);
  });
  return Promise.race([work, limit]).finally(() => clearTimeout(timer));
}
