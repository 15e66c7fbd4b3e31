/**
 * What a journey asks of a browser, whichever engine it has.
 *
 * @typedef {object} Driver
 * @property {string} engine
 * @property {string} version
 * @property {string} downloads the folder that files are downloaded to
 * @property {(url: string) => Promise<void>} open
 * @property {() => Promise<void>} reload
 * @property {(script: string) => Promise<any>} evaluate the value, as JSON can say it, of the body of an async function in the page
 * @property {(sources: object[]) => Promise<void>} act input as WebDriver describes it
 * @property {() => Promise<Buffer>} screenshot PNG
 * @property {() => Promise<string[]>} errors errors that nobody caught, and those written to the console
 * @property {() => Promise<void>} close
 */

/** The browser crashed; not a failure of the page's scripts. */
export class BrowserCrashed extends Error {
  constructor() {
    super("the browser crashed");
  }
}

const STEPS = 8;
/** A pointer that goes at a person's speed, so that no engine takes two moves for one. */
const STEP_MS = 16;

/** A mouse and a keyboard on top of a driver. */
export class Hand {
  /** @param {Driver} driver */
  constructor(driver) {
    this.driver = driver;
  }

  /**
   * Clicks what the selector finds, in its middle.
   *
   * @param {string} selector
   */
  async click(selector) {
    const place = await this.#middle(selector);
    await this.#point([move(place), { type: "pointerDown", button: 0 }, { type: "pointerUp", button: 0 }]);
  }

  /** @param {{ x: number, y: number }} from @param {{ x: number, y: number }} by CSS px */
  async drag(from, by) {
    const shares = Array.from({ length: STEPS }, (_, step) => (step + 1) / STEPS);
    const way = shares.map((share) => move({ x: from.x + share * by.x, y: from.y + share * by.y }, STEP_MS));
    await this.#point([move(from), { type: "pointerDown", button: 0 }, ...way, { type: "pointerUp", button: 0 }]);
  }

  /** @param {{ x: number, y: number }} to */
  async moveTo(to) {
    await this.#point([move(to)]);
  }

  /**
   * Types into a field instead of what is in it, and leaves it.
   *
   * @param {string} selector
   * @param {string} text
   * @param {"tab" | "enter"} leaving
   */
  async type(selector, text, leaving) {
    await this.click(selector);
    await this.driver.evaluate(`document.querySelector(${JSON.stringify(selector)}).select()`);
    // WebDriver's names of the keys.
    const keys = [...text, { tab: "\uE004", enter: "\uE007" }[leaving]];
    const actions = keys.flatMap((value) => ["keyDown", "keyUp"].map((type) => ({ type, value })));
    await this.driver.act([{ type: "key", id: "keyboard", actions }]);
  }

  /** @param {object[]} actions */
  #point(actions) {
    return this.driver.act([{ type: "pointer", id: "mouse", parameters: { pointerType: "mouse" }, actions }]);
  }

  /** @param {string} selector @returns {Promise<{ x: number, y: number }>} */
  async #middle(selector) {
    const place = await this.driver.evaluate(`
      const element = document.querySelector(${JSON.stringify(selector)});
      if (!element) return null;
      element.scrollIntoView({ block: "center" });
      const box = element.getBoundingClientRect();
      return box.width > 0 ? { x: box.x + box.width / 2, y: box.y + box.height / 2 } : null;`);
    if (!place) throw new Error(`there is no ${selector} to be clicked`);
    return place;
  }
}

/** @param {{ x: number, y: number }} place */
function move({ x, y }, duration = 0) {
  return { type: "pointerMove", duration, x: Math.round(x), y: Math.round(y), origin: "viewport" };
}
