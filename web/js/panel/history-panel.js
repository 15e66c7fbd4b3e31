import { announce } from "../page/announce.js";
import { byId, enableAction, make, onAction } from "../page/dom.js";
import { setUpEditKeys } from "../viewport/shortcuts.js";
import { takeTargetName } from "../words/names.js";
import { onLocaleChange, isWord, t, formatNumber } from "../words/words.js";

/**
 * @typedef {import("../viewport/host.js").Host} Host
 * @typedef {import("../viewport/host.js").StudioState} StudioState
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioEntry} StudioEntry
 */

/** Maximum number of listed entries. Older entries are counted below the list. */
const MAX_LISTED = 100;

/**
 * Sets up undo, redo, reset and the list of edits.
 *
 * @param {Host} host
 */
export function setUpHistoryPanel(host) {
  const undo = () => {
    host.act((studio) => studio.undo());
    announce(t("undone"));
  };
  const redo = () => {
    host.act((studio) => studio.redo());
    announce(t("redone"));
  };
  onAction("undo", undo);
  onAction("redo", redo);
  onAction("reset-selection", () => {
    host.act((studio) => studio.resetSelection());
    announce(t("was-reset.one", { name: host.ask((studio) => takeTargetName(studio.selectedTarget)) ?? "" }));
  });
  onAction("reset", () => {
    host.act((studio) => studio.reset());
    announce(t("was-reset"));
  });
  setUpEditKeys({ undo, redo, cancel: () => host.act((studio) => studio.cancel()) });
  host.onChange((state) => show(state, host));
  onLocaleChange(() => host.announce());
}

/**
 * @param {StudioState} state
 * @param {Host} host
 */
function show({ canUndo, canRedo, canResetSelection, entryCount }, host) {
  enableAction("undo", canUndo);
  enableAction("redo", canRedo);
  enableAction("reset-selection", canResetSelection);
  enableAction("reset", entryCount > 0);
  byId("history-empty", HTMLParagraphElement).hidden = entryCount > 0;
  const entries = host.answer((studio) => studio.latestEntries(MAX_LISTED));
  const rows = entries.map((entry) => row(entry, host)).reverse();
  for (const entry of entries) entry.free();
  if (entryCount > entries.length) rows.push(make("li", "earlier", t("history.earlier", { n: entryCount - entries.length })));
  byId("history", HTMLOListElement).replaceChildren(...rows);
}

/**
 * Row for one edit: checkbox, target and amount.
 *
 * @param {StudioEntry} entry
 * @param {Host} host
 */
function row({ index, target, amount, unit, enabled, waitsForDensity, impossible }, host) {
  const name = takeTargetName(target) ?? "";
  const item = make("li");
  item.toggleAttribute("data-off", !enabled || impossible);
  const checkbox = make("input");
  checkbox.type = "checkbox";
  checkbox.checked = enabled;
  checkbox.setAttribute("aria-label", t("history.takes-part", { name }));
  checkbox.addEventListener("change", () => {
    host.act((studio) => studio.setEntryEnabled(index, checkbox.checked));
  });
  const amountText = `${formatNumber(amount, unit === "%" ? 0 : 1)} ${unit}`;
  item.append(checkbox, make("span", "what", name), make("span", "how-much", amountText));
  if (waitsForDensity !== undefined) {
    const key = `density.${waitsForDensity}`;
    item.append(make("span", "waits", t("history.waits", { density: isWord(key) ? t(key) : "" })));
  }
  if (impossible) item.append(make("span", "waits", t("history.impossible")));
  return item;
}
