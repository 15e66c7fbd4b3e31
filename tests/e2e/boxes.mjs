// Finds layout problems: elements that overlap, leave the window, are cut or covered.
import * as basics from "./boxes/basics.mjs";
import * as cuts from "./boxes/cuts.mjs";
import * as overlaps from "./boxes/overlaps.mjs";

/** Source of the functions that run in the page. */
const SOURCE = Object.entries({ ...basics, ...cuts, ...overlaps })
  .map(([name, value]) => (typeof value === "function" ? String(value) : `const ${name} = ${JSON.stringify(value)};`))
  .join("\n");

/** Layout problems of the page. @returns {Promise<string[]>} */
export function findings(page) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${overlaps.lookOver.name}(); })()`);
}

/** Elements over a box of the stage, in CSS px of the window. @returns {Promise<string[]>} */
export function over(page, box) {
  return page.evaluate(`(() => { ${SOURCE}\nreturn ${overlaps.lyingOver.name}(${JSON.stringify(box)}); })()`);
}
