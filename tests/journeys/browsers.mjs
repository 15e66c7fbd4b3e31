import { launch } from "./browser.mjs";
import { movingFilm } from "./film.mjs";
import { portraitFilm } from "./pictures.mjs";

/** @typedef {import("./journey.mjs").Journey["needs"]} Needs */
/** @typedef {import("playwright-core").Browser} Browser */

/** Browsers whose screenshots do not show the 3D view. @type {Set<Needs>} */
const UNSEEN = new Set(["gpu", "camera", "moving-camera", "way-back"]);

/** Letting go of a page takes a browser a moment. One that takes longer than this never does. */
const CLOSING_MS = 30_000;

/** The browsers of one lane, each launched when it is first needed. */
export class Browsers {
  /** @type {Map<Needs, { browser: Browser, pid: number }>} */
  #open = new Map();
  #isTimed;

  /** @param {{ isTimed: boolean }} how what is timed is timed as visitors have it */
  constructor({ isTimed }) {
    this.#isTimed = isTimed;
  }

  /** Whether screenshots show the 3D view. @param {Needs} needs */
  sees(needs) {
    return this.#isTimed || !UNSEEN.has(needs);
  }

  /** Another one where the last has crashed. @param {Needs} needs */
  async for(needs) {
    const last = this.#open.get(needs);
    const open = last?.browser.isConnected() ? last : await this.#launch(needs);
    this.#open.set(needs, open);
    return open.browser;
  }

  /**
   * Has a visitor leave. A browser that does not let go of the page is ended, and the next journey has another.
   *
   * @param {import("./visitor.mjs").Visitor} visitor
   * @returns whether it let go
   */
  async leave(visitor) {
    if (await isDone(visitor.leave())) return true;
    for (const [needs, { browser, pid }] of this.#open) {
      if (browser !== visitor.page.context().browser()) continue;
      this.#open.delete(needs);
      end(pid);
    }
    return false;
  }

  async close() {
    for (const { browser, pid } of this.#open.values()) if (!(await isDone(browser.close()))) end(pid);
  }

  /** @param {Needs} needs */
  async #launch(needs) {
    const browser = await this.#launchFor(needs);
    const session = await browser.newBrowserCDPSession();
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    await session.detach();
    return { browser, pid: processInfo.find(({ type }) => type === "browser").id };
  }

  /** @param {Needs} needs */
  async #launchFor(needs) {
    if (needs === "no-gpu") return launch({ gpu: "none" });
    if (needs === "webgl") return launch({ gpu: "webgl" });
    const seen = this.sees(needs);
    if (needs === "camera") return launch({ film: await portraitFilm(), seen });
    if (needs === "moving-camera" || needs === "seen-camera") return launch({ film: await movingFilm(), seen });
    return launch({ seen, keepsPages: needs === "way-back" });
  }
}

/** @param {number} pid of a browser, which may be gone by itself */
function end(pid) {
  try {
    process.kill(pid, "SIGKILL");
  } catch (error) {
    if (error.code !== "ESRCH") throw error;
  }
}

/** @param {Promise<void>} closing */
async function isDone(closing) {
  let timer;
  const late = new Promise((resolve) => {
    timer = setTimeout(() => resolve(false), CLOSING_MS);
  });
  const done = closing.then(
    () => true,
    () => false,
  );
  return Promise.race([done, late]).finally(() => clearTimeout(timer));
}
