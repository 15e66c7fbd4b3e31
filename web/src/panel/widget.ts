import { isWord, t } from "../words/words.ts";
import type { Intent, Widget } from "../../wasm/rosto-studio-web.js";
import { textOf } from "./phrase.ts";

/** Function that widgets call: applies an intent and shows the panels again. */
export type Send = (intent: Intent) => void;

/** A widget on the page. The element stays while the widget's value changes, and with it focus and open folds. */
export interface View<C = any> {
  element: HTMLElement;
  /** `withChildren`: also shows the widgets of a group, of which newer values may be shown. */
  show(widget: Widget, control: C, withChildren: boolean): void;
}

/** Id of a widget's element. */
export function domId(id: string) {
  return id.replaceAll(".", "-");
}

/** Label of a widget: its own, or the word of its id. */
export function labelOf({ id, label }: Widget) {
  if (label) return textOf(label);
  return isWord(id) ? t(id) : textOf({ key: id, values: [] });
}
