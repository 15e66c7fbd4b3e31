/**
 * Fills in the measured figures of README.md and docs/: `node docs/figures.mjs`. They come from docs/benchmarks.json,
 * docs/accuracy.json and the download budgets in package.json. tests/docs/figures.test.mjs compares them.
 *
 * A comment right after a figure holds its key: `0.97 ms<!-- edit/edit from nothing/468 vertices/rosto -->`.
 * `KEY ÷ PEER` is the ratio of a measurement to the same one by another peer. A line `<!-- figures: KEY -->` before a
 * table applies to its cells, whose headings replace `{row}` and `{column}`. The text sets unit and number of decimals.
 */

import { readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** @typedef {{ value: number, unit: string, subject: string }} Figure */
/** @typedef {Map<string, Figure>} Figures */

export const ROOT = join(import.meta.dirname, "..");

/** Units by kind, in terms of each kind's base unit. @type {Record<string, [kind: string, factor: number]>} */
const UNITS = {
  µs: ["time", 1e-3],
  ms: ["time", 1],
  s: ["time", 1e3],
  kB: ["size", 1],
  MB: ["size", 1e3],
  px: ["px", 1],
  µm: ["length", 1e-3],
  mm: ["length", 1],
  cm: ["length", 10],
  levels: ["levels", 1],
  "%": ["share", 1],
  times: ["ratio", 1],
  "×": ["ratio", 1],
};

const NUMBER = String.raw`[−-]?\d[\d,]*(?:\.\d+)?`;
const UNIT = Object.keys(UNITS).join("|");
/** A number, the rest up to the mark, and the mark's key. */
const MARKED = new RegExp(`(${NUMBER})( ?(?:${UNIT}))?<!-- (?!figures:)(.+?) -->`, "g");
/** A comment after a space is not a mark. */
const ANY_MARK = /(?<=\S)<!-- .+? -->/g;
const TABLE = /(<!-- figures: (.+?) -->\n+)((?:\|.*\n)+)/g;
const CODE_BLOCK = /^```.*?^```/gms;
const FORMULA = /^\$\$.*?^\$\$/gms;
/** Code, addresses, tags and formulas in a line. */
const INLINE = /`[^`\n]*`|\]\([^)]*\)|<[a-z/!][^>]*>|\$[^$\n]*\$/g;

const START = String.raw`(?<![\w.,×]|× )\d[\d.,]*`;
const MEASURED = String.raw`(?: ?(?:µs|ms|s|min|h|kB|MB|GB)| (?:seconds|minutes|hours|times))\b|×(?! ?\d)`;
const LENGTH_OR_SHARE = String.raw` ?(?:px|µm|mm|levels|%)(?!\w)`;
const TABLE_DECIMAL = String.raw`(?<=\| *)\d+\.\d+(?= *\|)`;
/** Times, sizes and ratios. */
const UNMARKED = new RegExp(`${START}(?:${MEASURED})`, "g");
/** On pages about figures, also lengths, shares, and table cells with a decimal number. */
const UNMARKED_STRICT = new RegExp(`${START}(?:${MEASURED}|${LENGTH_OR_SHARE})|${TABLE_DECIMAL}`, "g");

/** All figures by key, in lower case. @returns {Promise<Figures>} */
export async function figures() {
  /** @type {Figures} */
  const found = new Map();
  for (const { subject, by = null, value, unit } of await records()) {
    const key = keyOf([...subject, by]);
    if (found.has(key)) throw new Error(`two figures have the key "${key}"`);
    found.set(key, { value, unit, subject: keyOf(subject) });
  }
  return found;
}

/** @returns {Promise<{ subject: (string | null)[], by?: string | null, value: number, unit: string }[]>} */
async function records() {
  const json = async (/** @type {string} */ path) => JSON.parse(await readFile(join(ROOT, path), "utf8"));
  const speed = await json("docs/benchmarks.json");
  const accuracy = await json("docs/accuracy.json");
  const budgets = (await json("package.json"))["size-limit"];
  return [
    ...speed.map(({ task, what, size, peer: by, value, unit }) => ({ subject: [task, what, size], by, value, unit })),
    ...accuracy.figures.map((figure) => ({ ...figure, subject: [figure.task, figure.case, figure.measure] })),
    ...budgets.map(({ name, limit }) => {
      const [number, unit] = limit.split(" ");
      return { subject: ["budget", name], value: Number(number), unit };
    }),
  ];
}

/**
 * Returns the text with its marked figures taken from the data.
 *
 * @param {string} text
 * @param {Figures} figures
 */
export function filled(text, figures) {
  const inTables = text.replaceAll(TABLE, (_, mark, template, table) => mark + filledTable(table, template, figures));
  const marks = inTables.match(ANY_MARK)?.length ?? 0;
  let filledMarks = 0;
  const whole = inTables.replaceAll(MARKED, (_, number, unit, key) => {
    filledMarks += 1;
    return `${shown(number, unit, figureOf(key, figures))}${unit ?? ""}<!-- ${key} -->`;
  });
  if (filledMarks !== marks) throw new Error(`${marks - filledMarks} marks do not follow a number and a known unit`);
  return whole;
}

/**
 * Finds figures that need a mark and have none.
 *
 * @param {string} text
 * @param {readonly string[]} constants phrases that are limits, parameters or quotations
 * @param {{ strict?: boolean }} [options] whether lengths and shares need marks, too
 */
export function unmarked(text, constants, { strict = false } = {}) {
  const prose = [CODE_BLOCK, FORMULA, TABLE, MARKED, INLINE].reduce((left, part) => left.replaceAll(part, ""), text);
  const line = prose.replaceAll(/\s+/g, " ");
  const rest = constants.reduce((left, phrase) => left.replaceAll(phrase, ""), line);
  return rest.match(strict ? UNMARKED_STRICT : UNMARKED) ?? [];
}

/** Pages with figures, from the repository's root. */
export async function pages() {
  const paths = await readdir(join(ROOT, "docs"), { recursive: true });
  return ["README.md", ...paths.filter((path) => path.endsWith(".md")).map((path) => `docs/${path}`).toSorted()];
}

/** @param {string} table @param {string} template @param {Figures} figures */
function filledTable(table, template, figures) {
  const [head = "", rule = "", ...rows] = table.trimEnd().split("\n");
  const columns = cellsOf(head).map(plain);
  const filledRows = rows.map((row) => {
    const cells = cellsOf(row);
    const label = plain(cells[0] ?? "");
    const filledCells = cells.map((cell, at) => {
      if (at === 0 || !/\d/.test(cell) || cell.includes("<!--")) return cell;
      const key = template.replace("{row}", label).replace("{column}", columns[at] ?? "");
      return cell.replace(new RegExp(`(${NUMBER})( ?(?:${UNIT}))?`), (_, number, unit) => {
        return `${shown(number, unit, figureOf(key, figures))}${unit ?? ""}`;
      });
    });
    return `|${filledCells.join("|")}|`;
  });
  return `${[head, rule, ...filledRows].join("\n")}\n`;
}

/** @param {string} row */
function cellsOf(row) {
  return row.replace(/^\|/, "").replace(/\|\s*$/, "").split("|");
}

/**
 * A heading as part of a key: "found: Rosto" becomes "found/Rosto", "28,881 vertices" becomes "28881 vertices".
 *
 * @param {string} cell
 */
function plain(cell) {
  return cell.replaceAll(/[*`]|\[|\]\([^)]*\)/g, "").replaceAll(/(\d),(?=\d{3})/g, "$1").replaceAll(": ", "/").trim();
}

/** @param {string} key @param {Figures} figures @returns {{ value: number, unit: string }} */
function figureOf(key, figures) {
  const [name = "", other] = key.split(" ÷ ");
  const figure = lookedUp(name, figures);
  if (other === undefined) return figure;
  const peer = lookedUp(figures.has(other.toLowerCase()) ? other : keyOf([figure.subject, other]), figures);
  if (peer.unit !== figure.unit) throw new Error(`"${key}" divides ${figure.unit} by ${peer.unit}`);
  return { value: figure.value / peer.value, unit: "×" };
}

/** @param {string} key @param {Figures} figures */
function lookedUp(key, figures) {
  const figure = figures.get(key.toLowerCase());
  if (!figure) throw new Error(`no figure has the key "${key}"`);
  return figure;
}

/**
 * Formats a value with the decimals of the number in the text, in the text's unit.
 *
 * @param {string} number
 * @param {string | undefined} unit
 * @param {{ value: number, unit: string }} figure
 */
function shown(number, unit, figure) {
  const [kind, factor] = unitOf(unit?.trim() ?? figure.unit);
  const [ownKind, ownFactor] = unitOf(figure.unit);
  if (kind !== ownKind) throw new Error(`a figure in ${figure.unit} is shown in ${unit}`);
  const decimals = number.split(".")[1]?.length ?? 0;
  const [whole = "", fraction] = ((figure.value * ownFactor) / factor).toFixed(decimals).replace("-", "−").split(".");
  return [whole.replaceAll(/\B(?=(?:\d{3})+$)/g, ","), fraction].filter((part) => part !== undefined).join(".");
}

/** @param {string} name @returns {[kind: string, factor: number]} */
function unitOf(name) {
  return UNITS[name] ?? [name, 1];
}

/** @param {(string | null)[]} parts */
function keyOf(parts) {
  return parts.filter((part) => part !== null && part !== "").join("/").replaceAll(": ", "/").toLowerCase();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) {
  const known = await figures();
  for (const path of await pages()) {
    const text = await readFile(join(ROOT, path), "utf8");
    const whole = filled(text, known);
    if (whole === text) continue;
    await writeFile(join(ROOT, path), whole);
    console.log(`${path}: figures updated`);
  }
}
