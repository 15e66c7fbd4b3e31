import { placeOf } from "../files.js";

/** @typedef {keyof typeof import("../../words/en.json")} WordKey */
/** @typedef {Record<WordKey, string>} Words */

/** @typedef {{ id: string, name: string, tag: string }} Language */

/** Fingers do some things in another way than a mouse. */
const TOUCH = matchMedia("(pointer: coarse)");

/** Whose words stand in for those that another language lacks. */
const FIRST = "en";

/** @type {Language[]} */
let known = [];
let firstWords = /** @type {Words} */ ({});
/** @type {Map<string, Words>} every word of the page; `{name}` in a text is filled in */
const WORDS = new Map();

let current = FIRST;
let newest = current;
/** @type {Promise<void> | undefined} */
let learned;

/** @type {Set<() => void>} */
const listeners = new Set();
TOUCH.addEventListener("change", tellAll);

/**
 * Fetches the words, once. Nothing may be said before.
 *
 * @param {string} wanted a language as browsers name it, which is spoken if there are words of it
 */
export function loadWords(wanted) {
  learned ??= learnFirst(wanted);
  learned.catch(() => (learned = undefined));
  return learned;
}

/** @param {string} wanted */
async function learnFirst(wanted) {
  [known, firstWords] = await Promise.all([fetched("languages"), fetched(FIRST)]);
  WORDS.set(FIRST, firstWords);
  current = languageFor(wanted);
  newest = current;
  await learn(current);
  // The others come while nobody waits for them.
  for (const { id } of known) learn(id).catch(() => {});
}

/**
 * The page's own language nearest to one that a browser names.
 *
 * @param {string} wanted such as "pt-BR"
 */
export function languageFor(wanted) {
  return known.find(({ id }) => wanted.startsWith(id))?.id ?? FIRST;
}

/** The language the page speaks now. */
export function language() {
  return current;
}

/**
 * The text of `key` in the page's language, with `{name}` replaced from `values`. Where a finger is what points, `key.touch`
 * takes its place if there is one.
 *
 * @param {WordKey} key
 * @param {Record<string, string | number>} [values]
 */
export function t(key, values = {}) {
  const byTouch = `${key}.touch`;
  const asked = TOUCH.matches && isWord(byTouch) ? byTouch : key;
  const text = WORDS.get(current)?.[asked] ?? firstWords[asked];
  return text.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/**
 * Whether the page has words for this key: codes of errors come from elsewhere.
 *
 * @param {string} key
 * @returns {key is WordKey}
 */
export function isWord(key) {
  return key in firstWords;
}

/**
 * Runs `listener` now and after each change of language.
 *
 * @param {() => void} listener
 * @param {AbortSignal} [gone] when nobody needs to know any more
 */
export function onLocaleChange(listener, gone) {
  listeners.add(listener);
  gone?.addEventListener("abort", () => listeners.delete(listener));
  listener();
}

/**
 * Changes the page's language. Of several that are asked for while words are on their way, the last wins.
 *
 * @param {string} wanted
 */
export async function speak(wanted) {
  newest = wanted;
  await learn(wanted);
  if (newest !== wanted) return;
  current = wanted;
  tellAll();
}

/** Writes the words into every element that asks for them by `data-text` or `data-label`. */
export function writeWords() {
  document.documentElement.lang = tag();
  for (const element of document.querySelectorAll("[data-text]")) {
    const key = element.getAttribute("data-text") ?? "";
    if (isWord(key)) element.textContent = t(key);
  }
  for (const element of document.querySelectorAll("[data-label]")) {
    const key = element.getAttribute("data-label") ?? "";
    if (!isWord(key)) continue;
    element.setAttribute("aria-label", t(key));
    if (element instanceof HTMLButtonElement) element.title = t(key);
  }
}

/**
 * A number as the page's language writes it.
 *
 * @param {number} value
 * @param {number} decimals
 */
export function formatNumber(value, decimals) {
  const tidy = Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value;
  return new Intl.NumberFormat(tag(), {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
  }).format(tidy);
}

/** The languages that the page speaks, by their own names. */
export function languages() {
  return known;
}

/** The page's language as HTML and the browser know it. */
function tag() {
  return known.find(({ id }) => id === current)?.tag ?? current;
}

/** Runs every listener of {@link onLocaleChange}, as after names have changed. */
export function tellAll() {
  for (const listener of listeners) listener();
}

/** @param {string} id */
async function learn(id) {
  if (!WORDS.has(id)) WORDS.set(id, await fetched(id));
}

/** @param {string} name */
async function fetched(name) {
  const response = await fetch(placeOf(`words/${name}.json`, new URL(`../../words/${name}.json`, import.meta.url)));
  if (!response.ok) throw new Error(`${response.status} for the words of ${name}`);
  return response.json();
}
