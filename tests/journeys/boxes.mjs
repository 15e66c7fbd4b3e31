// Looks over a page for what a visitor would stumble over: things that overlap, leave the window, are cut or covered.
import * as basics from "./boxes/basics.mjs";
import * as cuts from "./boxes/cuts.mjs";
import * as overlaps from "./boxes/overlaps.mjs";

const { isSeen } = basics;
const { cutting, leaving, sideways, spilling } = cuts;
const { covered, lyingOver, overlapping } = overlaps;

/** All that runs in the page, as its source. */
const SOURCE = [...Object.entries({ ...basics, ...cuts, ...overlaps }), ["lookOver", lookOver]]
  .map(([name, value]) => (typeof value === "function" ? String(value) : `const ${name} = ${JSON.stringify(value)};`))
  .join("\n");

/**
 * What is wrong with the boxes of the page as it stands; nothing if nothing is.
 *
 * @param {import("@playwright/test").Page} page
 * @returns {Promise<string[]>}
 */
export function findings(page) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${lookOver.name}(); })()`);
}

/**
 * What floats or stands over a box of the stage: over the chin, say.
 *
 * @param {import("@playwright/test").Page} page
 * @param {{ left: number, top: number, right: number, bottom: number }} box in CSS px of the window
 * @returns {Promise<string[]>}
 */
export function over(page, box) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${lyingOver.name}(${JSON.stringify(box)}); })()`);
}

/** Runs in the page. @returns {string[]} */
function lookOver() {
  const modal = document.querySelector("dialog:modal");
  const scope = modal ?? document.body;
  const all = [...scope.querySelectorAll("*")].filter(isSeen);
  const found = [...(modal ? [] : overlapping()), ...leaving(all), ...spilling(all), ...cutting(all), ...covered(scope), ...sideways()];
  return [...new Set(found)];
}
