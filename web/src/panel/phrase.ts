import { formatNumber, isWord, t } from "../words/words.ts";
import type { Part, Phrase } from "../../wasm/rosto-studio-web.js";

/** The text of a phrase in the current language. An id without a word is shown as it is. */
export function textOf({ key, values }: Phrase): string {
  const parts = Object.fromEntries(values.map(([name, part]) => [name, textOfPart(part)]));
  return isWord(key) ? t(key, parts) : key.slice(key.indexOf(".") + 1).replaceAll("-", " ");
}

function textOfPart(part: Part): string {
  if (typeof part === "string") return part;
  return Array.isArray(part) ? formatNumber(part[0], part[1]) : textOf(part);
}
