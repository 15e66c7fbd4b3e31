import { setTimeout as later } from "node:timers/promises";
import { launch } from "./browser.mjs";
import { movingVideo } from "./video.mjs";
import { portraitVideo } from "./pictures.mjs";

/** Launch options of each kind of browser; `seen`: screenshots show the 3D view. */
const KINDS = {
  gpu: () => ({ seen: false }),
  eyes: () => ({ seen: true }),
  webgl: () => ({ seen: true, gpu: "webgl" }),
  "no-gpu": () => ({ seen: true, gpu: "none" }),
  camera: async () => ({ seen: false, video: await portraitVideo() }),
  "moving-camera": async () => ({ seen: false, video: await movingVideo() }),
  "seen-camera": async () => ({ seen: true, video: await movingVideo() }),
  "way-back": () => ({ seen: false, keepsPages: true }),
};

/** @typedef {keyof typeof KINDS} Kind */
/** @typedef {{ browser: import("@playwright/test").Browser, pid: number, seen: boolean }} Open */

/** Time limit for closing a page or a browser. */
const CLOSING_MS = 30_000;

/** Kind of browser for a test's tags. @param {string[]} tags @returns {Kind} */
export function kindFor(tags) {
  return /** @type {Kind} */ (Object.keys(KINDS).find((kind) => tags.includes(`@${kind}`)) ?? "gpu");
}

/** Browsers of one worker, launched when needed and relaunched after a crash. */
export class Browsers {
  /** @type {Map<Kind, Open>} */
  #open = new Map();

  /** Whether screenshots of an open browser show the 3D view. @param {Kind} kind */
  showsView(kind) {
    return this.#open.get(kind).seen;
  }

  /** @param {Kind} kind */
  async get(kind) {
    if (!this.#open.get(kind)?.browser.isConnected()) this.#open.set(kind, await launched(kind));
    return this.#open.get(kind).browser;
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

/** @param {Kind} kind @returns {Promise<Open>} */
async function launched(kind) {
  const options = await KINDS[kind]();
  const browser = await launch(options);
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  return { browser, pid: processInfo.find(({ type }) => type === "browser").id, seen: options.seen };
}

/** Kills a browser that hangs while closing. @param {Promise<void>} closing @param {Open | undefined} open */
async function closeOrKill(closing, open) {
  const isClosed = await Promise.race([closing.then(() => true, () => true), later(CLOSING_MS, false, { ref: false })]);
  if (isClosed || !open?.browser.isConnected()) return;
  console.log("killed a browser that hung while closing");
  process.kill(open.pid, "SIGKILL");
}
