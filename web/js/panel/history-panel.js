import { announce } from "../page/announce.js";
import { byId, enableAction, make, onAction } from "../page/dom.js";
import { setUpEditKeys } from "../viewport/shortcuts.js";
import { inEveryLanguage, language, say, sayNumber } from "../words/words.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioEntry} StudioEntry
 * @typedef {import("../words/words.js").WordKey} WordKey
 */

/**
 * The list of edits, undo, redo and reset.
 *
 * @param {Workbench} bench
 */
export function setUpHistoryPanel(bench) {
  const undo = () => {
    bench.act((studio) => {
      // What is still moving becomes an edit first, and is what undo takes back.
      studio.commit();
      studio.undo();
    });
    announce(say("undone"));
  };
  const redo = () => {
    bench.act((studio) => studio.redo());
    announce(say("redone"));
  };
  onAction("undo", undo);
  onAction("redo", redo);
  onAction("reset-selection", () => {
    bench.act((studio) => studio.resetSelection());
    announce(say("was-reset.one", { name: bench.studio.selectionName(language()) ?? "" }));
  });
  onAction("reset", () => {
    bench.act((studio) => studio.reset());
    announce(say("was-reset"));
  });
  setUpEditKeys({ undo, redo, cancel: () => bench.act((studio) => studio.cancel()) });
  bench.onChange((state) => show(state, bench));
  inEveryLanguage(() => bench.announce());
}

/**
 * @param {StudioState} state
 * @param {Workbench} bench
 */
function show(state, bench) {
  // While an edit is in progress, the list stays as it is.
  if (state.editing) return;
  const { entries } = state;
  enableAction("undo", state.canUndo);
  enableAction("redo", state.canRedo);
  enableAction("reset-selection", state.canResetSelection);
  enableAction("reset", entries.length > 0);
  byId("history-empty", HTMLParagraphElement).hidden = entries.length > 0;
  byId("history", HTMLOListElement).replaceChildren(...entries.map((entry) => row(entry, bench)).reverse());
}

/**
 * One edit: what it changed and how much, and whether it takes part.
 *
 * @param {StudioEntry} entry
 * @param {Workbench} bench
 */
function row(entry, bench) {
  const { index, amount, unit, enabled, waitsForDensity } = entry;
  const name = bench.studio.entryName(index, language());
  const item = make("li");
  item.toggleAttribute("data-off", !enabled);
  const takesPart = make("input");
  takesPart.type = "checkbox";
  takesPart.checked = enabled;
  takesPart.setAttribute("aria-label", say("history.takes-part", { name }));
  takesPart.addEventListener("change", () => {
    bench.act((studio) => studio.setEntryEnabled(index, takesPart.checked));
  });
  const howMuch = `${sayNumber(amount, unit === "%" ? 0 : 1)} ${unit}`;
  item.append(takesPart, make("span", "what", name), make("span", "how-much", howMuch));
  if (waitsForDensity !== undefined) {
    const points = say(/** @type {WordKey} */ (`density.${waitsForDensity}`));
    item.append(make("span", "waits", say("history.waits", { points })));
  }
  return item;
}
