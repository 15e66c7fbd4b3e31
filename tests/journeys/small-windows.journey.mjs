import assert from "node:assert/strict";
import { alike, test } from "./fixtures.mjs";
import { STATES, withHeldWork, wrongWith } from "./states.mjs";

/** Windows smaller than, or between, those of the contact sheets. */
const WINDOWS = [
  { width: 320, height: 568, hasTouch: true },
  { width: 640, height: 360, hasTouch: true },
];

const SEEN = ["empty", "working", "arrived", "selected", "view", "export", "notice", "keys"];

for (const [{ width, height, hasTouch = false }, tag] of alike(WINDOWS)) {
  test(`in a small window of ${width} × ${height} everything is in reach, and nothing overlaps or is cut`, { tag }, async ({ open }) => {
    const visitor = await open({ viewport: { width, height }, hasTouch, isMobile: hasTouch, before: withHeldWork });
    /** @type {string[]} */
    const found = [];
    for (const state of STATES.filter(({ id }) => SEEN.includes(id))) {
      await state.enter(visitor);
      for (const language of ["en", "pt"]) {
        await visitor.speak(language);
        found.push(...(await wrongWith(visitor, state)).map((finding) => `${finding} (${state.id}, ${language})`));
      }
      await state.leave?.(visitor);
    }
    assert.deepEqual(found, []);
  });
}
