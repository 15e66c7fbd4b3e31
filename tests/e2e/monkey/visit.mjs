import { readFile } from "node:fs/promises";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { launch } from "../browser.mjs";
import { Visitor } from "../visitor.mjs";
import { installMonkey } from "./page.mjs";

/** Time limit for a frame. */
const FRAME_MS = 30_000;
/** Time limit for an action; a check makes three files. */
const ACTION_MS = 300_000;
const OPENING_MS = 30_000;
/** Notices that report an internal inconsistency. */
const INTERNAL = new Set(["internal", "other", "bad-vertex", "bad-choice", "no-selection"]);

/** Kinds of visitor: options of {@link Visitor.open}. @type {Record<string, import("../visitor.mjs").Visit & import("@playwright/test").BrowserContextOptions>} */
export const KINDS = {
  desktop: { viewport: { width: 1024, height: 640 }, expert: true },
  phone: { viewport: { width: 390, height: 700 }, hasTouch: true },
};

/** One run of the monkey test, in its own browser. The first problem ends it. */
export class Visit {
  /** Latest download of each kind, by extension. @type {Map<string, Buffer>} */
  downloads = new Map();
  /** Number of actions performed. */
  done = 0;

  /** @param {string} url @param {string} video file for the fake camera @param {string} kind of visitor */
  static async start(url, video, kind) {
    const browser = await launch({ video, seen: false });
    const { page, errors, consoleLines } = await Visitor.open(browser, url, { ...KINDS[kind], scripts: [installMonkey] });
    const visit = Object.assign(new Visit(), { page, errors, consoleLines, input: await page.context().newCDPSession(page) });
    page.on("crash", () => errors.push(new Error("the page's process died")));
    page.on("download", async (download) => {
      // A reload may abort it.
      const bytes = await download.path().then(readFile).catch(() => undefined);
      if (bytes) visit.downloads.set(path.extname(download.suggestedFilename()), bytes);
    });
    await visit.look();
    return visit;
  }

  /** Performs an action and checks the page. @param {() => Promise<void>} act */
  async perform(act) {
    this.done += 1;
    const limit = setTimeout(ACTION_MS, undefined, { ref: false }).then(() => {
      throw new Error(`an action did not end within ${ACTION_MS / 1000} s`);
    });
    const failure = await Promise.race([act(), limit]).then(() => this.look()).then(() => undefined, (error) => error);
    // An error of the page explains the failed action.
    const fault = this.errors[0] ?? this.consoleLines.find((line) => line.startsWith("error: ")) ?? failure;
    if (fault) throw fault instanceof Error ? fault : new Error(fault);
  }

  /** Reads the page's state after its next frames. @returns {Promise<import("./page.mjs").Seen>} */
  async look(frames = 1) {
    // Unlike `evaluate`, `waitForFunction` survives a reload.
    const seen = await this.page.waitForFunction((frames) => window["monkey"].look(frames), frames, { timeout: FRAME_MS });
    this.seen = await seen.jsonValue();
    if (INTERNAL.has(this.seen.error)) throw new Error(`notice ${this.seen.error}: ${this.seen.notice}`);
    return this.seen;
  }

  /**
   * Clicks a button even if it is not visible; returns whether it is enabled.
   *
   * @param {string} selector
   * @returns {Promise<boolean>}
   */
  press(selector) {
    return this.page.evaluate((selector) => window["monkey"].press(selector), selector);
  }

  /** Waits until no file is being opened. */
  async untilQuiet() {
    await this.look(3);
    await this.page.waitForSelector("#progress", { state: "hidden", timeout: OPENING_MS }).catch(() => {});
  }

  /**
   * Resumes the saved work if it is offered in time.
   *
   * @param {number} limit_ms
   * @returns {Promise<boolean>} whether it was
   */
  async resume(limit_ms) {
    const offer = "#continue:not([hidden])";
    await this.page.waitForSelector(offer, { timeout: limit_ms, state: "attached" }).catch(() => {});
    if (!(await this.press(offer))) return false;
    await this.page.waitForSelector("body[data-state='face']", { timeout: OPENING_MS });
    await this.untilQuiet();
    return true;
  }
}
