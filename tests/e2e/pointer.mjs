
const STEPS = 6;

/** @type {WeakMap<import("@playwright/test").Page, ReturnType<typeof mouse> | ReturnType<typeof finger>>} */
const POINTERS = new WeakMap();

/** Touch on windows with a coarse pointer, otherwise the mouse. It can stay pressed between calls. */
export const Pointer = {
  /** @param {import("./visitor.mjs").Visitor} visitor */
  async of({ page }) {
    const isTouch = await page.evaluate(() => matchMedia("(pointer: coarse)").matches);
    if (!POINTERS.has(page)) POINTERS.set(page, isTouch ? finger(await page.context().newCDPSession(page)) : mouse(page.mouse));
    return POINTERS.get(page);
  },
};

/** @param {import("@playwright/test").Mouse} mouse */
function mouse(mouse) {
  return {
    press: async (/** @type {Place} */ { x, y }) => {
      await mouse.move(x, y);
      await mouse.down();
    },
    move: (/** @type {Place} */ _, /** @type {Place} */ { x, y }) => mouse.move(x, y, { steps: STEPS }),
    release: () => mouse.up(),
  };
}

/** @param {import("@playwright/test").CDPSession} session */
function finger(session) {
  const send = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  return {
    press: (/** @type {Place} */ place) => send("touchStart", [place]),
    move: async (/** @type {Place} */ from, /** @type {Place} */ to) => {
      for (let step = 1; step <= STEPS; step++) {
        const [x, y] = [from.x + ((to.x - from.x) * step) / STEPS, from.y + ((to.y - from.y) * step) / STEPS];
        await send("touchMove", [{ x, y }]);
      }
    },
    release: () => send("touchEnd", []),
  };
}
