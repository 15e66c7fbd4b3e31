/** @typedef {{ x: number, y: number }} Place in CSS px of the window */

const STEPS = 6;

/** @type {WeakMap<import("@playwright/test").Page, Hand>} */
const HANDS = new WeakMap();

/** What a visitor points with: a finger where the window takes one, else the mouse. It may stay down for as long as it likes. */
export class Hand {
  /** @param {import("./visitor.mjs").Visitor} visitor */
  static async of({ page }) {
    const known = HANDS.get(page);
    if (known) return known;
    const isTouch = await page.evaluate(() => matchMedia("(pointer: coarse)").matches);
    const hand = new Hand(page, isTouch ? await page.context().newCDPSession(page) : undefined);
    HANDS.set(page, hand);
    return hand;
  }

  /** @param {import("@playwright/test").Page} page @param {import("@playwright/test").CDPSession} [touch] */
  constructor(page, touch) {
    this.page = page;
    this.touch = touch;
  }

  /** @param {Place} place */
  async press(place) {
    if (this.touch) return this.#send("touchStart", [place]);
    await this.page.mouse.move(place.x, place.y);
    await this.page.mouse.down();
  }

  /** @param {Place} from @param {Place} to */
  async move(from, to) {
    for (let step = 1; step <= STEPS; step++) {
      const share = step / STEPS;
      const place = { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
      if (this.touch) await this.#send("touchMove", [place]);
      else await this.page.mouse.move(place.x, place.y);
    }
  }

  async release() {
    if (this.touch) await this.#send("touchEnd", []);
    else await this.page.mouse.up();
  }

  /** @param {"touchStart" | "touchMove" | "touchEnd"} type @param {Place[]} touchPoints */
  #send(type, touchPoints) {
    return this.touch.send("Input.dispatchTouchEvent", { type, touchPoints });
  }
}
