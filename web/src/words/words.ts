import english from "../../words/en.json" with { type: "json" };
import languageList from "../../words/languages.json" with { type: "json" };

export type WordKey = keyof typeof english;
type Words = Record<WordKey, string>;

/** The available languages: id, native name and BCP 47 tag. */
export const languages: { id: string; name: string; tag: string }[] = languageList;

/** Its words are part of the page. */
const FALLBACK = "en";
/** Loads the words of the other languages. */
const OTHERS: Record<string, () => Promise<{ default: Words }>> = {
  pt: () => import("../../words/pt.json", { with: { type: "json" } }),
};
/** Some texts differ for touch input. */
const TOUCH = matchMedia("(pointer: coarse)");

let words: Words = english;
let current = FALLBACK;
/** Requested language, which may still be loading. */
let requested = current;
let loading: Promise<void> | undefined;

const listeners = new Set<() => void>();
TOUCH.addEventListener("change", notifyLocaleChange);

/**
 * Loads the words of the first available language, once. The page is in English until then, and after a failure.
 *
 * @param tags preferred languages, as BCP 47 tags
 */
export function loadWords(...tags: string[]) {
  loading ??= setLanguage(languageFor(...tags)).catch(() => {}).then(preload);
  return loading;
}

/** Loads the other languages, so that a later choice needs no request. */
function preload() {
  for (const load of Object.values(OTHERS)) load().catch(() => {});
}

/**
 * The first available language, or the fallback.
 *
 * @param tags such as "pt-BR"
 */
export function languageFor(...tags: string[]) {
  const ids = tags.map((tag) => tag.toLowerCase().split("-")[0]);
  return ids.find((id) => languages.some((language) => language.id === id)) ?? FALLBACK;
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
  const text = words[TOUCH.matches && isWord(touchKey) ? touchKey : key];
  return text.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
}

/** Whether a text exists for a key, for keys built at run time such as those of error codes. */
export function isWord(key: string): key is WordKey {
  return key in english;
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
  const loaded = await OTHERS[id]?.();
  if (requested !== id) return;
  [current, words] = [id, loaded?.default ?? english];
  notifyLocaleChange();
}

/** Translates the elements with `data-text` or `data-label`. */
export function translatePage() {
  document.documentElement.lang = tag();
  for (const element of document.querySelectorAll<HTMLElement>("[data-text], [data-label]")) {
    const { text = "", label = "" } = element.dataset;
    if (isWord(text)) element.textContent = t(text);
    if (isWord(label)) element.ariaLabel = t(label);
    if (isWord(label) && element instanceof HTMLButtonElement) element.title = t(label);
  }
}

/** Formats a number in the current language. Avoids "-0". */
export function formatNumber(value: number, decimals: number) {
  const digits = { minimumFractionDigits: decimals, maximumFractionDigits: decimals };
  return formatOf({ ...digits, signDisplay: "negative" }).format(value);
}

/** Formats a number for a text field: without trailing zeros and grouping. */
export function formatTyped(value: number, decimals: number) {
  return formatOf({ maximumFractionDigits: decimals, useGrouping: false }).format(value);
}

/** Kept, because a format takes longer to make than hundreds of numbers to format. */
const formats = new Map<string, Intl.NumberFormat>();

function formatOf(options: Intl.NumberFormatOptions) {
  const key = tag() + JSON.stringify(options);
  const format = formats.get(key) ?? new Intl.NumberFormat(tag(), options);
  formats.set(key, format);
  return format;
}

/** BCP 47 tag of the current language. */
function tag() {
  return languages.find(({ id }) => id === current)?.tag ?? current;
}

/** Calls the listeners of {@link onLocaleChange}. */
export function notifyLocaleChange() {
  for (const listener of listeners) listener();
}
