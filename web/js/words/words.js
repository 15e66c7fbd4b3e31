import { remember, remembered } from "../page/remember.js";

/** @typedef {keyof typeof import("../../words/en.json")} WordKey */
/** @typedef {Record<WordKey, string>} Words */
/** @typedef {"en" | "pt"} Language */

const [en, pt] = await Promise.all([wordsOf("en"), wordsOf("pt")]);
/** Every word of the page; each language has the same keys, and `{name}` in a text is filled in. */
const LANGUAGES = { en, pt };

/** @type {Language} */
let current = firstLanguage();

/** @type {Set<() => void>} */
const listeners = new Set();

/** The language the page speaks now. */
export function language() {
  return current;
}

/**
 * The text of `key` in the page's language, with `{name}` replaced from `values`.
 *
 * @param {WordKey} key
 * @param {Record<string, string | number>} [values]
 */
export function say(key, values = {}) {
  return LANGUAGES[current][key].replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/**
 * Whether the page has words for this key: codes of errors come from elsewhere.
 *
 * @param {string} key
 * @returns {key is WordKey}
 */
export function isWord(key) {
  return key in en;
}

/**
 * Runs `listener` now and after each change of language.
 *
 * @param {() => void} listener
 */
export function inEveryLanguage(listener) {
  listeners.add(listener);
  listener();
}

/**
 * Changes the page's language and remembers it.
 *
 * @param {string} wanted
 */
export function speak(wanted) {
  current = wanted === "pt" ? "pt" : "en";
  remember("language", current);
  for (const listener of listeners) listener();
}

/** Writes the words into every element that asks for them by `data-text` or `data-label`. */
export function writeWords() {
  document.documentElement.lang = current === "pt" ? "pt-BR" : "en";
  for (const element of document.querySelectorAll("[data-text]")) {
    const key = element.getAttribute("data-text") ?? "";
    if (isWord(key)) element.textContent = say(key);
  }
  for (const element of document.querySelectorAll("[data-label]")) {
    const key = element.getAttribute("data-label") ?? "";
    if (!isWord(key)) continue;
    element.setAttribute("aria-label", say(key));
    if (element instanceof HTMLButtonElement) element.title = say(key);
  }
}

/**
 * A number as the page's language writes it.
 *
 * @param {number} value
 * @param {number} decimals
 */
export function sayNumber(value, decimals) {
  const tidy = Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value;
  return new Intl.NumberFormat(current === "pt" ? "pt-BR" : "en", {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
  }).format(tidy);
}

/**
 * @param {Language} name
 * @returns {Promise<Words>}
 */
async function wordsOf(name) {
  const response = await fetch(new URL(`../../words/${name}.json`, import.meta.url));
  if (!response.ok) throw new Error(`${response.status} for the words of ${name}`);
  return response.json();
}

/** @returns {Language} */
function firstLanguage() {
  const wanted = remembered("language") ?? navigator.language;
  return wanted.startsWith("pt") ? "pt" : "en";
}
