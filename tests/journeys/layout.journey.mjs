import assert from "node:assert/strict";
import { AUDIENCES } from "./audiences.mjs";
import { findings, over } from "./boxes.mjs";
import { journey } from "./journey.mjs";
import { STATES, withHeldWork } from "./states.mjs";

/** Bottom of the chin. */
const CHIN = "152";

const SEEN = ["empty", "working", "arrived", "selected", "view", "export", "downloaded", "notice", "keys", "group", "returning"];

for (const { id, options } of AUDIENCES) {
  journey(`in a window of ${id.replace("x", " × ")} nothing overlaps, is cut or covered, in either language`, async (open) => {
    const visitor = await open({ ...options, colorScheme: "light", before: withHeldWork });
    /** Each finding with the state in which it was first seen. @type {Map<string, string>} */
    const found = new Map();
    const tell = (what, where) => found.set(what, found.get(what) ?? where);
    for (const state of STATES.filter((state) => SEEN.includes(state.id))) {
      await state.enter(visitor);
      for (const language of ["en", "pt"]) {
        await speak(visitor, language);
        for (const what of await findings(visitor.page)) tell(what, `${state.id}, ${language}`);
      }
      if (state.id === "arrived") for (const name of await overChin(visitor)) tell(`${name} lies over the chin`, state.id);
      await state.leave?.(visitor);
    }
    assert.deepEqual([...found], []);
  });
}

/** What floats over the lowest point of the face. @param {import("./visitor.mjs").Visitor} visitor */
async function overChin(visitor) {
  await visitor.findLandmark(CHIN);
  const { x, y } = await visitor.tagged();
  const names = await over(visitor.page, { left: x - 8, right: x + 8, top: y - 4, bottom: y + 4 });
  return names.filter((name) => name !== "#landmark-tag");
}

/** The page in another language, as by its list of them, which phones hide. */
async function speak(/** @type {import("./visitor.mjs").Visitor} */ visitor, language) {
  await visitor.page.evaluate((language) => {
    const choice = document.getElementById("language");
    choice.value = language;
    choice.dispatchEvent(new Event("change"));
  }, language);
  await visitor.page.waitForFunction((language) => document.documentElement.lang.startsWith(language), language);
  await visitor.frames(2);
}
