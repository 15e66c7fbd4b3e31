import { announce } from "../page/announce.js";
import { byId, enableAction, make, onAction } from "../page/dom.js";
import { setUpEditKeys } from "../viewport/shortcuts.js";
import { targetName } from "../words/names.js";
import { onLocaleChange, isWord, t, formatNumber } from "../words/words.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").State} State
 * @typedef {import("../../wasm/rosto-studio-web.js").Entry} Entry
 */

/**
 * Sets up undo, redo, reset and the list of edits.
 *
 * @param {Host} host
 */
export function setUpHistoryPanel(host) {
  const undo = () => {
    host.apply("undo");
    announce(t("undone"));
  };
  const redo = () => {
    host.apply("redo");
    announce(t("redone"));
  };
  onAction("undo", undo);
  onAction("redo", redo);
  onAction("reset-selection", () => {
    host.apply("reset-selected");
    announce(t("was-reset.one", { name: host.read(({ target }) => target && targetName(target)) ?? "" }));
  });
  onAction("reset", () => {
    host.apply("reset");
    announce(t("was-reset"));
  });
  setUpEditKeys({ undo, redo, cancel: () => host.apply("cancel") });
  host.onChange((state) => show(state, host));
  onLocaleChange(() => host.announce());
}

/**
 * Older entries are counted below the list.
 *
 * @param {State} state
 * @param {Host} host
 */
function show({ canUndo, canRedo, canResetSelection, entryCount, entries }, host) {
  enableAction("undo", canUndo);
  enableAction("redo", canRedo);
  enableAction("reset-selection", canResetSelection);
  enableAction("reset", entryCount > 0);
  byId("history-empty", HTMLParagraphElement).hidden = entryCount > 0;
  const rows = entries.map((entry) => row(entry, host)).reverse();
  if (entryCount > entries.length) rows.push(make("li", "earlier", t("history.earlier", { n: entryCount - entries.length })));
  byId("history", HTMLOListElement).replaceChildren(...rows);
}

/**
 * Row for one edit: checkbox, target and amount.
 *
 * @param {Entry} entry
 * @param {Host} host
 */
function row({ index, target, amount, unit, isEnabled, waitsForDensity, isImpossible }, host) {
  const name = targetName(target);
  const item = make("li");
  item.toggleAttribute("data-off", !isEnabled || isImpossible);
  const checkbox = make("input");
  checkbox.type = "checkbox";
  checkbox.checked = isEnabled;
  checkbox.setAttribute("aria-label", t("history.takes-part", { name }));
  checkbox.addEventListener("change", () => {
    host.apply({ switch: [index, checkbox.checked] });
  });
  const amountText = `${formatNumber(amount, unit === "%" ? 0 : 1)} ${unit}`;
  item.append(checkbox, make("span", "what", name), make("span", "how-much", amountText));
  if (waitsForDensity !== undefined) {
    const key = `density.${waitsForDensity}`;
    item.append(make("span", "waits", t("history.waits", { density: isWord(key) ? t(key) : "" })));
  }
  if (isImpossible) item.append(make("span", "waits", t("history.impossible")));
  return item;
}
