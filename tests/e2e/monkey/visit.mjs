import { readFile } from "node:fs/promises";
import path from "node:path";
import { setTimeout } from "node:timers/promises";
import { launch } from "../browser.mjs";
import { Visitor } from "../visitor.mjs";
import { letMonkeyIn } from "./page.mjs";

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
  /** Actions done. */
  done = 0;

  /** @param {string} url @param {string} film the file that the camera plays */
  static async start(url, video) {
    const browser = await launch({ video, seen: false });
    const options = { viewport: { width: 760, height: 480 }, hasTouch: true, expert: true, scripts: [letMonkeyIn] };
    const { page, broken, said } = await Visitor.arrive(browser, url, options);
    const visit = Object.assign(new Visit(), { page, broken, said, input: await page.context().newCDPSession(page) });
    page.on("crash", () => broken.push(new Error("the page's process died")));
    page.on("download", async (download) => {
      // One that a reload breaks off never comes.
      const bytes = await download.path().then(readFile).catch(() => undefined);
      if (bytes) visit.downloads.set(path.extname(download.suggestedFilename()), bytes);
    });
    await visit.look();
    return visit;
  }

  /** Does something and looks at what came of it. @param {() => Promise<void>} act */
  async perform(act) {
    this.done += 1;
    const limit = setTimeout(ACTION_MS, undefined, { ref: false }).then(() => {
      throw new Error(`an action did not end within ${ACTION_MS / 1000} s`);
    });
    const failure = await Promise.race([act(), limit]).then(() => this.look()).then(() => undefined, (error) => error);
    // The page's own error explains what the visitor ran into.
    const fault = this.broken[0] ?? this.said.find((line) => line.startsWith("error: ")) ?? failure;
    if (fault) throw fault instanceof Error ? fault : new Error(fault);
  }

  /** Looks at the page after its next frames. @returns {Promise<import("./page.mjs").Seen>} */
  async look(frames = 1) {
    // Unlike an evaluation, this outlives a page that is being left for its reloaded self.
    const seen = await this.page.waitForFunction((frames) => window["monkey"].look(frames), frames, { timeout: FRAME_MS });
    this.seen = await seen.jsonValue();
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
    await this.page.waitForSelector("#progress", { state: "hidden", timeout: OPENING_MS }).catch(() => {});
  }

  /** Resumes the stored work, if it is offered in time. @param {number} limit_ms @returns {Promise<boolean>} whether it was */
  async resume(limit_ms) {
    const offer = "#continue:not([hidden])";
    await this.page.waitForSelector(offer, { timeout: limit_ms, state: "attached" }).catch(() => {});
    if (!(await this.press(offer))) return false;
    await this.page.waitForSelector("body[data-state='face']", { timeout: OPENING_MS });
    await this.untilQuiet();
    return true;
  }
}
