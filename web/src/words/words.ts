import english from "../../words/en.json" with { type: "json" };
import languageList from "../../words/languages.json" with { type: "json" };

export type WordKey = keyof typeof import("../../words/en.json");
type Words = Record<WordKey, string>;

export type Language = { id: string; name: string; tag: string; };

/** Some texts differ for touch input. */
const TOUCH = matchMedia("(pointer: coarse)");

/** Its words are part of the page, and replace keys that another language lacks. */
const FALLBACK = "en";

const available: Language[] = languageList;
const fallbackWords: Words = english;
/** Loads the words of the other languages. */
const OTHERS: Record<string, () => Promise<{ default: Words; }>> = { pt: () => import("../../words/pt.json", { with: { type: "json" } }) };
const WORDS: Map<string, Words> = new Map([[FALLBACK, fallbackWords]]);

let current = FALLBACK;
/** Requested language, which may still be loading. */
let requested = current;
let loading: Promise<void> | undefined;

const listeners: Set<() => void> = new Set();
TOUCH.addEventListener("change", notifyLocaleChange);

/**
 * Loads the words, once. Call it before {@link t}.
 *
 * @param tag preferred language, as a BCP 47 tag
 */
export function loadWords(tag: string) {
  loading ??= loadInitial(tag);
  loading.catch(() => (loading = undefined));
  return loading;
}

async function loadInitial(tag: string) {
  requested = languageFor(tag);
  // Without its words, the page starts in English.
  if (await loadLanguage(requested).then(() => true, () => false)) current = requested;
  // Preload the other languages in the background.
  for (const { id } of available) loadLanguage(id).catch(() => {});
}

/**
 * The available language for a BCP 47 tag, or the fallback.
 *
 * @param tag such as "pt-BR"
 */
export function languageFor(tag: string) {
  return available.find(({ id }) => tag.startsWith(id))?.id ?? FALLBACK;
}

/** The current language. */
export function language() {
  return current;
}

/**
 * The text of `key` in the current language, with `{name}` replaced from `values`. On touch screens, `key.touch` takes
 * precedence if it exists.
 */
export function t(key: WordKey, values: Record<string, string | number> = {}) {
  const touchKey = `${key}.touch`;
  const textKey = TOUCH.matches && isWord(touchKey) ? touchKey : key;
  const text = WORDS.get(current)?.[textKey] ?? fallbackWords[textKey];
  return text.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/** Whether a text exists for a key, for keys built at run time such as those of error codes. */
export function isWord(key: string): key is WordKey {
  return key in fallbackWords;
}

/**
 * Calls `listener` now and after each change of language.
 *
 * @param signal removes the listener
 */
export function onLocaleChange(listener: () => void, signal?: AbortSignal) {
  listeners.add(listener);
  signal?.addEventListener("abort", () => listeners.delete(listener));
  listener();
}

/** Changes the current language once its words are loaded. A later call supersedes a pending one. */
export async function setLanguage(id: string) {
  requested = id;
  await loadLanguage(id);
  if (requested !== id) return;
  current = id;
  notifyLocaleChange();
}

/** Translates the elements with `data-text` or `data-label`. */
export function translatePage() {
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

/** Formats a number in the current language. */
export function formatNumber(value: number, decimals: number) {
  // Avoids "-0".
  const rounded = Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value;
  return new Intl.NumberFormat(tag(), {
    minimumFractionDigits: decimals,
    maximumFractionDigits: decimals,
  }).format(rounded);
}

/** The available languages, with their native names. */
export function languages() {
  return available;
}

/** BCP 47 tag of the current language. */
function tag() {
  return available.find(({ id }) => id === current)?.tag ?? current;
}

/** Calls the listeners of {@link onLocaleChange}. */
export function notifyLocaleChange() {
  for (const listener of listeners) listener();
}

async function loadLanguage(id: string) {
  const words = WORDS.has(id) ? undefined : await OTHERS[id]?.();
  if (words) WORDS.set(id, words.default);
}
