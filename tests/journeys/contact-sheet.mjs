// Takes a picture of every main state of the built page in every window, language and theme, looks each over by its boxes
// and puts them together: docs/images/contact/LANGUAGE-THEME.jpg. All of them take a while: --sizes 390x844,720x450,
// --states empty,arrived, --languages pt and --themes dark take some, --keep FOLDER leaves each picture there as well, and
// --out FOLDER writes elsewhere.
import { mkdir, writeFile } from "node:fs/promises";
import { availableParallelism } from "node:os";
import path from "node:path";
import { parseArgs } from "node:util";
import { AUDIENCES, LOCALES } from "./audiences.mjs";
import { launch } from "./browser.mjs";
import { chinFindings } from "./chin.mjs";
import { DIST, serve } from "./server.mjs";
import { writeSheet } from "./sheets.mjs";
import { STATES, withHeldWork, wrongWith } from "./states.mjs";
import { Visitor } from "./visitor.mjs";

/** @typedef {"light" | "dark"} Theme */
/** @typedef {{ state: string, size: string, language: string, theme: Theme, picture: Uint8Array, found: string[] }} Shot */

const THEMES = /** @type {Theme[]} */ (["light", "dark"]);
const CELL = { width: 480, height: 400 };
const LANES = Math.min(2, availableParallelism());

const { values: asked } = parseArgs({
  options: Object.fromEntries(["sizes", "states", "languages", "themes", "keep", "out"].map((name) => [name, { type: /** @type {const} */ ("string") }])),
});
const states = only(asked.states, STATES, ({ id }) => id);
const audiences = only(asked.sizes, AUDIENCES, ({ id }) => id);
const languages = only(asked.languages, Object.keys(LOCALES), (id) => id);
const themes = only(asked.themes, THEMES, (id) => id);
const out = path.resolve(asked.out ?? path.join(import.meta.dirname, "../../docs/images/contact"));

const server = await serve(DIST, "/");
/** @type {Shot[]} */
const shots = [];
const waiting = languages.flatMap((language) => audiences.map((audience) => ({ language, audience })));
await Promise.all(Array.from({ length: LANES }, walkInLane));
await writeSheets();
server.close();
/** Each finding with the pictures that show it. @type {Map<string, string[]>} */
const found = new Map();
for (const { found: seen, state, size, language } of shots) {
  for (const what of seen) found.set(what, [...(found.get(what) ?? []), `${state} ${size} ${language}`]);
}
for (const [what, where] of found) console.log(`${what}: ${where.join(", ")}`);
console.log(`contact sheet: ${shots.length} pictures, ${found.size} findings`);
process.exitCode = found.size === 0 ? 0 : 1;

async function walkInLane() {
  const browser = await launch();
  for (let next = waiting.shift(); next; next = waiting.shift()) await walk(browser, next);
  await browser.close();
}

/**
 * One visit through all states. The theme follows the system's, and changes under the page's feet.
 *
 * @param {import("playwright-core").Browser} browser
 * @param {{ language: string, audience: import("./audiences.mjs").Audience }} who
 */
async function walk(browser, { language, audience }) {
  const started = performance.now();
  const visitor = await Visitor.arrive(browser, server.url, {
    ...audience.options, locale: LOCALES[language], colorScheme: themes[0], before: withHeldWork,
  });
  for (const state of states) {
    const where = { state: state.id, size: audience.id, language };
    try {
      await state.enter(visitor);
      await look(visitor, state, where);
      await state.leave?.(visitor);
    } catch (error) {
      shots.push({ ...where, theme: themes[0], picture: await visitor.page.screenshot(), found: [`cannot be reached: ${String(error).split("\n")[0]}`] });
    }
  }
  await visitor.leave();
  console.log(`${audience.id} ${language} (${((performance.now() - started) / 1000).toFixed(0)} s)`);
}

/**
 * @param {Visitor} visitor
 * @param {import("./states.mjs").State} state
 * @param {{ state: string, size: string, language: string }} where
 */
async function look(visitor, state, where) {
  for (const theme of themes) {
    await visitor.page.emulateMedia({ colorScheme: theme });
    await visitor.frames(5);
    const found = theme === themes[0] ? await wrongWith(visitor, state) : [];
    const picture = await visitor.page.screenshot();
    if (state.face && theme === themes[0]) found.push(...(await chinFindings(visitor)));
    shots.push({ ...where, theme, picture, found });
  }
}

async function writeSheets() {
  const browser = await launch();
  for (const language of languages) {
    for (const theme of themes) {
      const file = path.join(out, `${language}-${theme}.jpg`);
      await writeSheet(browser, file, { rows: states.map(({ id }) => audiences.map((audience) => cellOf(id, audience.id, language, theme))), theme, ...CELL });
      console.log(path.relative(process.cwd(), file));
    }
  }
  await browser.close();
  if (asked.keep) await keep(path.resolve(asked.keep));
}

/** @param {string} state @param {string} size @param {string} language @param {Theme} theme */
function cellOf(state, size, language, theme) {
  const shot = shots.find((one) => one.state === state && one.size === size && one.language === language && one.theme === theme);
  if (!shot) return undefined;
  const note = shot.found.length > 0 ? `${shot.found.length} to look at` : "";
  return { picture: shot.picture, caption: `${state} · ${size.replace("x", " × ")}`, note };
}

/** @param {string} folder */
async function keep(folder) {
  await mkdir(folder, { recursive: true });
  for (const { state, size, language, theme, picture } of shots) {
    await writeFile(path.join(folder, `${size}-${language}-${theme}-${state}.png`), picture);
  }
}

/**
 * What was asked for by name, or all.
 *
 * @template T
 * @param {string | undefined} list
 * @param {T[]} all
 * @param {(one: T) => string} idOf
 * @returns {T[]}
 */
function only(list, all, idOf) {
  if (!list) return all;
  const names = list.split(",");
  const unknown = names.filter((name) => !all.some((one) => idOf(one) === name));
  if (unknown.length > 0) throw new Error(`no ${unknown.join(", ")}; there are ${all.map(idOf).join(", ")}`);
  return all.filter((one) => names.includes(idOf(one)));
}
