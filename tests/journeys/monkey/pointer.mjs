import { setTimeout } from "node:timers/promises";
import fc from "fast-check";

/**
 * @typedef {{ x: number, y: number }} Place in shares of an element's width and height
 * @typedef {{ type: string, x?: number, y?: number, button?: "left" | "right" | "middle", modifiers?: number, deltaY?: number, key?: string, fingers?: Place[] }} Move
 *   a mouse event of Chromium's protocol, or "key", "rest", "cancel" or "touch", which lists all fingers that are down
 */

/** A finger that rests this long selects. */
const REST_MS = 520;
const BUTTONS = { left: 1, right: 2, middle: 4 };
const [ALT, CTRL, SHIFT] = [1, 2, 8];

/** From 0 to 1. */
export const share = fc.nat(9999).map((number) => number / 10_000);
const middle = fc.integer({ min: 2500, max: 7500 }).map((number) => number / 10_000);
/** Most places are on the face. */
const place = fc.oneof({ weight: 4, arbitrary: fc.record({ x: middle, y: middle }) }, { weight: 1, arbitrary: fc.record({ x: share, y: share }) });
const button = fc.constantFrom("left", "left", "left", "left", "left", "left", "right", "middle");
const modifiers = fc.constantFrom(0, 0, 0, 0, 0, 0, SHIFT, ALT, CTRL, SHIFT | ALT);
const several = (/** @type {fc.Arbitrary<Move>} */ move) => fc.array(move, { minLength: 1, maxLength: 6 });

const move = moving("mouseMoved", {});
const wheel = moving("mouseWheel", { deltaX: fc.constant(0), deltaY: fc.constantFrom(-3000, -400, -100, 100, 400, 3000), modifiers: fc.constantFrom(0, 0, 0, CTRL) });
const key = fc.record({ type: fc.constant("key"), key: fc.constantFrom("Escape", "x", "y", "z", "Control+z", "w", "b", "Tab") });
const cancel = fc.constant({ type: "cancel" });
const touch = fc.record({ type: fc.constant("touch"), fingers: fc.array(place, { minLength: 1, maxLength: 2 }) });
/** Anything that can come in the middle of a drag. */
const meanwhile = fc.oneof({ weight: 20, arbitrary: move }, { weight: 3, arbitrary: key }, { weight: 1, arbitrary: wheel }, { weight: 1, arbitrary: cancel });

const click = fc.record({ from: place, way: fc.constant([]), how: fc.record({ button, modifiers }) }).map(pressed);
const drag = fc.record({ from: place, way: several(meanwhile), how: fc.record({ button, modifiers }) }).map(pressed);
const fingers = fc.tuple(several(fc.oneof({ weight: 6, arbitrary: touch }, { weight: 1, arbitrary: fc.constant({ type: "rest" }) })), fc.constantFrom("touch", "touch", "touch", "cancel"))
  .map(([moves, last]) => [...moves, { type: last, fingers: [] }]);

/** A click, a drag, a hover, a scroll, or what fingers do. @type {fc.Arbitrary<Move[]>} */
export const gesture = fc.oneof(
  { weight: 4, arbitrary: click },
  { weight: 6, arbitrary: drag },
  { weight: 2, arbitrary: several(move) },
  { weight: 2, arbitrary: several(wheel) },
  { weight: 2, arbitrary: fingers },
);

/** @param {string} type @param {Record<string, fc.Arbitrary<unknown>>} how */
function moving(type, how) {
  return fc.record({ type: fc.constant(type), place, ...how }).map(({ place, ...rest }) => ({ ...rest, ...place }));
}

/** @param {{ from: Place, way: Move[], how: Partial<Move> }} gesture */
function pressed({ from, way, how }) {
  const to = way.findLast(({ type }) => type === "mouseMoved") ?? from;
  const moved = way.map((move) => (move.type === "mouseMoved" ? { ...move, ...how } : move));
  return [{ type: "mouseMoved", ...from }, { type: "mousePressed", ...from, ...how }, ...moved, { type: "mouseReleased", ...to, ...how }];
}

/** @param {import("./visit.mjs").Visit} visit @param {string} selector @param {Move[]} moves */
export async function play(visit, selector, moves) {
  const box = await visit.page.locator(selector).boundingBox();
  if (!box) return;
  const at = ({ x = 0, y = 0 }) => ({ x: box.x + x * box.width, y: box.y + y * box.height });
  // The mouse does not wait for the page; anything that comes in between waits for the mouse.
  let mouse = Promise.resolve();
  for (const { type, key, fingers, ...how } of moves) {
    if (type.startsWith("mouse")) mouse = point(visit, { type, ...how, ...at(how) });
    else await mouse;
    if (type === "rest") await setTimeout(REST_MS);
    if (type === "key") await visit.page.keyboard.press(key);
    if (type === "cancel") await takeAway(visit);
    if (type === "touch") await put(visit, fingers.map(at));
  }
  await mouse;
}

/** @param {import("./visit.mjs").Visit} visit @param {Move} move */
async function point({ input }, move) {
  const buttons = move.type === "mouseReleased" ? 0 : (BUTTONS[move.button] ?? 0);
  await input.send("Input.dispatchMouseEvent", { ...move, buttons, clickCount: move.type === "mouseMoved" ? 0 : 1 });
}

/** @param {import("./visit.mjs").Visit} visit @param {Place[]} fingers all that touch from now on */
async function put(visit, fingers) {
  const type = fingers.length === 0 ? "touchEnd" : visit.isTouching ? "touchMove" : "touchStart";
  if (type === "touchEnd" && !visit.isTouching) return;
  visit.isTouching = fingers.length > 0;
  await visit.input.send("Input.dispatchTouchEvent", { type, touchPoints: fingers.map((finger, id) => ({ ...finger, id })) });
}

/** The system takes the pointer away, as it does for a gesture of its own. @param {import("./visit.mjs").Visit} visit */
async function takeAway(visit) {
  if (visit.isTouching) {
    visit.isTouching = false;
    return visit.input.send("Input.dispatchTouchEvent", { type: "touchCancel", touchPoints: [] });
  }
  return visit.page.evaluate(() => {
    document.getElementById("viewport").dispatchEvent(new PointerEvent("pointercancel", { pointerId: 1, pointerType: "mouse", bubbles: true }));
  });
}
