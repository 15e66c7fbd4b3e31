import { setTimeout } from "node:timers/promises";
import fc from "fast-check";

/**
 * @typedef {{ x: number, y: number }} Place as fractions of an element's size
 * @typedef {{ type: string, at?: Place, button?: keyof BUTTONS, modifiers?: number, key?: string, fingers?: Place[] }} Move
 *   a mouse or touch event of Chromium's protocol, or "key", "rest" or "cancel"; `fingers`: all fingers that are down
 */

/** Duration of a long press. */
const REST_MS = 520;
const BUTTONS = { left: 1, right: 2, middle: 4 };
const [ALT, CTRL, SHIFT] = [1, 2, 8];

/** One of several arbitraries, each with its weight. @template T @param {[number, fc.Arbitrary<T>][]} choices */
export const often = (...choices) => fc.oneof(...choices.map(([weight, arbitrary]) => ({ weight, arbitrary })));
const several = (one, maxLength = 6) => fc.array(one, { minLength: 1, maxLength });

/** From 0 to 1. */
export const share = fc.nat(9999).map((number) => number / 10_000);
const middle = share.map((number) => 0.25 + number / 2);
/** Mostly on the face. */
const place = often([4, fc.record({ x: middle, y: middle })], [1, fc.record({ x: share, y: share })]);
const button = often([6, fc.constant("left")], [1, fc.constant("right")], [1, fc.constant("middle")]);
const modifiers = often([6, fc.constant(0)], [4, fc.constantFrom(SHIFT, ALT, CTRL, SHIFT | ALT)]);

const move = fc.record({ type: fc.constant("mouseMoved"), at: place });
const wheel = fc.record({
  type: fc.constant("mouseWheel"),
  at: place,
  deltaX: fc.constant(0),
  deltaY: fc.constantFrom(-3000, -400, -100, 100, 400, 3000),
  modifiers: often([3, fc.constant(0)], [1, fc.constant(CTRL)]),
});
const key = fc.record({ type: fc.constant("key"), key: fc.constantFrom("Escape", "x", "y", "z", "Control+z", "w", "b", "Tab") });
/** Events in the middle of a drag. */
const meanwhile = often([20, move], [3, key], [1, wheel], [1, fc.constant({ type: "cancel" })]);
const way = often([4, fc.constant([])], [6, several(meanwhile)]);
const press = fc.record({ from: place, way, how: fc.record({ button, modifiers }) }).map(({ from, way, how }) => {
  const to = way.findLast(({ type }) => type === "mouseMoved")?.at ?? from;
  const moved = way.map((move) => (move.type === "mouseMoved" ? { ...move, ...how } : move));
  const pressed = { type: "mousePressed", at: from, ...how };
  return [{ type: "mouseMoved", at: from }, pressed, ...moved, { ...pressed, type: "mouseReleased", at: to }];
});

const touch = fc.record({ type: fc.constant("touchMove"), fingers: several(place, 2) });
const strokes = several(often([6, touch], [1, fc.constant({ type: "rest" })]));
const end = often([3, fc.constant("touchEnd")], [1, fc.constant("touchCancel")]);
const fingers = fc.record({ fingers: several(place, 2), strokes, end })
  .map(({ fingers, strokes, end }) => [{ type: "touchStart", fingers }, ...strokes, { type: end, fingers: [] }]);

/** A click, drag, hover, scroll or touch gesture. @type {fc.Arbitrary<Move[]>} */
export const gesture = often([10, press], [2, several(move)], [2, several(wheel)], [2, fingers]);

/** @param {import("./visit.mjs").Visit} visit @param {string} selector @param {Move[]} moves */
export async function play({ page, input }, selector, moves) {
  const box = await page.locator(selector).boundingBox();
  if (!box) return;
  const inBox = ({ x, y }) => ({ x: box.x + x * box.width, y: box.y + y * box.height });
  // Mouse events are sent without waiting; other events wait for them.
  let mouse = Promise.resolve();
  for (const { type, at, key, fingers, ...how } of moves) {
    if (!type.startsWith("mouse")) await mouse;
    if (type === "rest") await setTimeout(REST_MS);
    else if (type === "key") await page.keyboard.press(key);
    // The system cancels the pointer, for example for its own gesture.
    else if (type === "cancel") await page.dispatchEvent("#viewport", "pointercancel", { pointerId: 1, pointerType: "mouse" });
    else if (fingers) {
      await input.send("Input.dispatchTouchEvent", { type, touchPoints: fingers.map((finger, id) => ({ ...inBox(finger), id })) });
    } else {
      const buttons = type === "mouseReleased" ? 0 : (BUTTONS[how.button] ?? 0);
      mouse = input.send("Input.dispatchMouseEvent", { type, ...how, ...inBox(at), buttons, clickCount: type === "mouseMoved" ? 0 : 1 });
    }
  }
  await mouse;
}
