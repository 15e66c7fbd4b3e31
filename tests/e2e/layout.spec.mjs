import assert from "node:assert/strict";
import { expect } from "@playwright/test";
import { WINDOW_SIZES } from "./window-sizes.mjs";
import { findings } from "./boxes.mjs";
import { chinFindings } from "./chin.mjs";
import { variants, test } from "./fixtures.mjs";
import { STATES, allowDelayedReplies, problemsOf } from "./states.mjs";

/** Windows smaller than the common ones, and the states tested in them. */
const SMALL = [{ width: 320, height: 568 }, { width: 640, height: 360 }];
const SEEN_SMALL = STATES.filter(({ id }) => ["empty", "working", "arrived", "selected", "view", "export", "notice", "keys"].includes(id));

const WINDOWS = [
  ...variants(WINDOW_SIZES.map(({ options }) => ({ ...options, states: STATES }))),
  ...SMALL.map((viewport) => [{ viewport, hasTouch: true, isMobile: true, states: SEEN_SMALL }, []]),
];

for (const [{ states, ...options }, tag] of WINDOWS) {
  const { width, height } = options.viewport;
  test(`in a window of ${width} × ${height}, nothing overlaps or is cut or covered in either language`, { tag }, async ({ open }) => {
    const visitor = await open({ ...options, colorScheme: "light", before: allowDelayedReplies });
    /** Each finding with the first state that has it. @type {Map<string, string>} */
    const found = new Map();
    for (const state of states) {
      await state.enter(visitor);
      for (const language of ["en", "pt"]) {
        await visitor.setLanguage(language);
        for (const what of await problemsOf(visitor, state)) found.set(what, found.get(what) ?? `${state.id}, ${language}`);
      }
      await state.leave?.(visitor);
    }
    assert.deepEqual([...found], []);
  });
}

test("the face stays within the uncovered part of the stage when the window changes", { tag: "@eyes" }, async ({ open }) => {
  const visitor = await open({ colorScheme: "light" });
  await visitor.openFace();
  for (const { id, options } of [...WINDOW_SIZES, ...WINDOW_SIZES.toReversed()]) {
    await visitor.page.setViewportSize(options.viewport);
    // The camera is animated.
    await expect.poll(() => chinFindings(visitor), { message: id }).toEqual([]);
  }
});

/** Faults to inject into a page without findings. @type {[string, string, string, RegExp][]} */
const FAULTS = [
  ["overlaps", "#hint", "bottom: 24px", /#hint and #toolbar overlap by/],
  ["leaves the window", "#hint", "left: -40px; transform: none", /#hint leaves #stage sideways by 40 px/],
  ["is cut", "#photo-change", "width: 24px", /the text of #photo-change is \d+ px wider than its box/],
  ["wraps", "#tab-export", "width: 40px; padding: 0; overflow-wrap: anywhere", /the text of #tab-export wraps/],
  ["is covered", "#hint", "inset: 0; width: auto; max-width: none; transform: none; z-index: 9", /#toolbar button\.icon-button is covered by #hint/],
  ["scrolls sideways", "#section-photo", "width: 400px", /#sections scrolls sideways by/],
];

test("each kind of layout fault is found", async ({ open }) => {
  const visitor = await open({ viewport: { width: 1280, height: 800 } });
  const { page } = visitor;
  await visitor.openFace();
  assert.deepEqual(await findings(page), []);
  for (const [fault, selector, style, sign] of FAULTS) {
    const element = page.locator(selector);
    const before = await element.evaluate(({ style }) => style.cssText);
    await element.evaluate((element, style) => (element.style.cssText += style), style);
    const found = await findings(page);
    assert.ok(found.some((what) => sign.test(what)), `not found: ${fault}; found: ${found.join("; ")}`);
    await element.evaluate((element, style) => (element.style.cssText = style), before);
  }
  assert.deepEqual(await findings(page), []);
});
