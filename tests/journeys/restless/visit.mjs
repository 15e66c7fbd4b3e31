import { readFile } from "node:fs/promises";
import { SAMPLE, Visitor } from "../visitor.mjs";
import { Chance } from "./chance.mjs";
import { check } from "./checks.mjs";
import { openEyes } from "./eyes.mjs";
import { Hands } from "./hands.mjs";
import { wish } from "./intents.mjs";

/**
 * @typedef {import("./intents.mjs").Action} Action
 * @typedef {import("./eyes.mjs").Seen} Seen
 * @typedef {{ message: string, stack?: string }} Finding
 * @typedef {{ actions: Action[], finding?: Finding, known: string[], took_ms: number }} Visited `known`: findings that were passed over
 */

/** What the page must draw a frame within. */
const ANSWER_MS = 30_000;
/** Long enough for the slowest thing that one action waits for. */
const ACTION_MS = 90_000;

/** Errors that ordinary use must never cause: they say that the page is at odds with itself. */
const OF_THE_PAGE = new Set(["internal", "other", "bad-vertex", "bad-choice", "no-selection"]);

/** Frames that are waited for after an action, and after the last one. */
const FRAMES = 1;
const LAST_FRAMES = 3;

/** What a browser context of a restless visitor is like. */
export const CONTEXT = {
  viewport: { width: 760, height: 480 },
  hasTouch: true,
  before: (/** @type {import("playwright-core").BrowserContext} */ context) => context.addInitScript(openEyes),
};

/**
 * What a visitor with this seed does, action by action.
 *
 * @param {number} seed
 * @param {number} count
 */
export function* wishes(seed, count) {
  const chance = new Chance(seed);
  let seen = yield;
  for (let number = 0; number < count; number++) seen = yield wish(chance, seen);
}

/**
 * The same actions again.
 *
 * @param {Action[]} actions
 */
export function* recorded(actions) {
  yield;
  for (const action of actions) yield action;
}

/** One visit to the page, until the wishes end or something is found. */
export class Visit {
  /** @type {Action[]} */
  actions = [];
  #error = /** @type {Finding[]} */ ([]);
  #known = /** @type {string[]} */ ([]);
  #isKnown = (/** @type {string} */ _) => false;
  #visitor;
  #hands;

  /** @param {Visitor} visitor that has just arrived @param {Hands} hands */
  constructor(visitor, hands) {
    this.#visitor = visitor;
    this.#hands = hands;
    this.#listen();
  }

  /** @param {Visitor} visitor opened with {@link CONTEXT} */
  static async of(visitor) {
    return new Visit(visitor, await Hands.of(visitor.page));
  }

  /**
   * @param {Generator<Action | undefined, void, Seen>} wishes
   * @param {object} [how]
   * @param {(action: Action, number: number) => void} [how.tell] called before each action
   * @param {(message: string) => boolean} [how.isKnown] whether a notice was found before: it does not end the visit
   * @returns {Promise<Visited>}
   */
  async go(wishes, { tell = () => {}, isKnown = () => false } = {}) {
    const started = performance.now();
    this.#isKnown = isKnown;
    wishes.next();
    let finding;
    try {
      let seen = await this.#look();
      for (let next = wishes.next(seen); !next.done && !this.#error[0]; next = wishes.next(seen)) {
        this.actions.push(next.value);
        tell(next.value, this.actions.length);
        await within(ACTION_MS, this.#perform(next.value, seen), "an action did not come to its end");
        seen = await this.#look();
      }
      await this.#look(LAST_FRAMES);
    } catch (error) {
      finding = { message: String(error?.message ?? error).split("\n")[0], stack: error?.stack };
    }
    // What the page said explains what the visitor ran into.
    return { actions: this.actions, finding: this.#error[0] ?? finding, known: this.#known, took_ms: performance.now() - started };
  }

  /** @param {Action} action @param {Seen} seen */
  async #perform(action, seen) {
    if (action.do !== "check") return this.#hands.perform(action, seen);
    const wrong = await check(this.#hands, action.what);
    if (wrong) this.#error.push({ message: wrong });
  }

  /** What the page shows after its next frames. @returns {Promise<Seen>} */
  async #look(frames = FRAMES) {
    const seen = await within(ANSWER_MS, this.#settled(frames), "the page does not answer");
    if (!OF_THE_PAGE.has(seen.error)) return seen;
    const message = `notice ${seen.error}: ${seen.said}`;
    if (!this.#isKnown(message)) this.#error.push({ message });
    else {
      this.#known.push(message);
      await this.#visitor.page.evaluate(() => window["__eyes"].press("#notice-close"));
    }
    return seen;
  }

  /** @param {number} frames */
  async #settled(frames) {
    for (;;) {
      try {
        return await this.#visitor.page.evaluate((frames) => window["__eyes"].settle(frames), frames);
      } catch (error) {
        // The page was being left for its reloaded self.
        if (!/context was destroyed|navigation/i.test(String(error))) throw error;
        await this.#visitor.page.waitForLoadState();
      }
    }
  }

  #listen() {
    const { page } = this.#visitor;
    page.removeAllListeners("filechooser");
    page.on("filechooser", (chooser) => chooser.setFiles(SAMPLE).catch(() => {}));
    page.on("pageerror", (error) => this.#error.push({ message: `page error: ${error.message}`, stack: error.stack }));
    page.on("crash", () => this.#error.push({ message: "the page's process died" }));
    page.on("console", (message) => {
      // Messages of the browser itself have no arguments, and differ between versions.
      if (message.type() === "error" && message.args().length > 0) this.#error.push({ message: `console: ${message.text().split("\n")[0]}`, stack: message.text() });
    });
    page.on("download", (download) => this.#pocket(download));
  }

  /** @param {import("playwright-core").Download} download */
  async #pocket(download) {
    const kind = { ".glb": "GLB", osto: "project" }[download.suggestedFilename().slice(-4)];
    if (!kind) return;
    // One that a reload breaks off never comes.
    const path = await download.path().catch(() => undefined);
    const bytes = path && (await readFile(path).catch(() => undefined));
    if (bytes) this.#hands.pocket.set(kind, bytes);
  }
}

/**
 * An action in one line.
 *
 * @param {Action} action
 */
export function inWords(action) {
  const { do: verb, ...rest } = action;
  if (action.do !== "pointer") return `${verb} ${JSON.stringify(rest)}`;
  const moves = action.moves.map(({ type, ...how }) => `${type}${JSON.stringify(how, (_, value) => (typeof value === "number" ? Number(value.toFixed(4)) : value))}`);
  return `${action.how} on the ${action.on}: ${moves.join(" ")}`;
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
