import { setTimeout as later } from "node:timers/promises";
import { launch } from "./browser.mjs";
import { movingFilm } from "./film.mjs";
import { portraitFilm } from "./pictures.mjs";

/** @typedef {import("@playwright/test").Browser} Browser */

/** Kinds of browsers: how each is launched, and whether its screenshots show the 3D view. */
const KINDS = {
  gpu: { seen: false, options: () => ({}) },
  eyes: { seen: true, options: () => ({}) },
  webgl: { seen: true, options: () => ({ gpu: "webgl" }) },
  "no-gpu": { seen: true, options: () => ({ gpu: "none" }) },
  camera: { seen: false, options: async () => ({ film: await portraitFilm() }) },
  "moving-camera": { seen: false, options: async () => ({ film: await movingFilm() }) },
  "seen-camera": { seen: true, options: async () => ({ film: await movingFilm() }) },
  "way-back": { seen: false, options: () => ({ keepsPages: true }) },
};

/** @typedef {keyof typeof KINDS} Kind */

/** Time limit for closing a page or a browser: one that takes longer hangs. */
const CLOSING_MS = 30_000;

/** Kind of browser that a test's tags ask for. @param {string[]} tags @returns {Kind} */
export function kindFor(tags) {
  return /** @type {Kind} */ (Object.keys(KINDS).find((kind) => tags.includes(`@${kind}`)) ?? "gpu");
}

/** Browsers of one worker, each launched when it is first needed, and again if it crashed. */
export class Browsers {
  /** @type {Map<Kind, { browser: Browser, pid: number }>} */
  #open = new Map();

  /** Whether screenshots show the 3D view. @param {Kind} kind */
  sees(kind) {
    return KINDS[kind].seen;
  }

  /** @param {Kind} kind */
  async get(kind) {
    const last = this.#open.get(kind);
    const open = last?.browser.isConnected() ? last : await launched(kind);
    this.#open.set(kind, open);
    return open.browser;
  }

  /** Closes a visitor's pages. @param {import("./visitor.mjs").Visitor} visitor */
  async release(visitor) {
    const open = [...this.#open.values()].find(({ browser }) => browser === visitor.page.context().browser());
    await closeOrKill(visitor.leave(), open);
  }

  async close() {
    for (const open of this.#open.values()) await closeOrKill(open.browser.close(), open);
  }
}

/** @param {Kind} kind */
async function launched(kind) {
  const { seen, options } = KINDS[kind];
  const browser = await launch({ seen, ...(await options()) });
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  return { browser, pid: processInfo.find(({ type }) => type === "browser").id };
}

/** A browser that hangs is killed. @param {Promise<void>} closing @param {{ browser: Browser, pid: number } | undefined} open */
async function closeOrKill(closing, open) {
  const isClosed = await Promise.race([closing.then(() => true, () => true), later(CLOSING_MS, false, { ref: false })]);
  if (isClosed || !open?.browser.isConnected()) return;
  console.log("a browser hung while closing, and was killed");
  process.kill(open.pid, "SIGKILL");
}
