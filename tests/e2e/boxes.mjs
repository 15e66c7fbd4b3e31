// Looks over a page for what a visitor would stumble over: things that overlap, leave the window, are cut or covered.
import * as basics from "./boxes/basics.mjs";
import * as cuts from "./boxes/cuts.mjs";
import * as overlaps from "./boxes/overlaps.mjs";

/** All that runs in the page, as its source. */
const SOURCE = Object.entries({ ...basics, ...cuts, ...overlaps })
  .map(([name, value]) => (typeof value === "function" ? String(value) : `const ${name} = ${JSON.stringify(value)};`))
  .join("\n");

/** What is wrong with the boxes of the page as it stands; nothing if nothing is. @returns {Promise<string[]>} */
export function findings(page) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${overlaps.lookOver.name}(); })()`);
}

/** What floats or stands over a box of the stage, in CSS px of the window: over the chin, say. @returns {Promise<string[]>} */
export function over(page, box) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${overlaps.lyingOver.name}(${JSON.stringify(box)}); })()`);
}
