import { announce } from "../page/announce.js";
import { byId, enableAction, make, onAction } from "../page/dom.js";
import { setUpEditKeys } from "../viewport/shortcuts.js";
import { sayOnce } from "../words/names.js";
import { inEveryLanguage, isWord, say, sayNumber } from "../words/words.js";

/**
 * @typedef {import("../viewport/workbench.js").Workbench} Workbench
 * @typedef {import("../viewport/workbench.js").StudioState} StudioState
 * @typedef {import("../../wasm/rosto-studio-web.js").StudioEntry} StudioEntry
 */

/** The list shows no more entries than this: the others are there, and can be taken back. */
const LISTED = 100;

/**
 * The list of edits, undo, redo and reset.
 *
 * @param {Workbench} bench
 */
export function setUpHistoryPanel(bench) {
  const undo = () => {
    bench.act((studio) => studio.undo());
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
    announce(say("was-reset.one", { name: bench.ask((studio) => sayOnce(studio.selectedTarget)) ?? "" }));
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
function show({ canUndo, canRedo, canResetSelection, entryCount }, bench) {
  enableAction("undo", canUndo);
  enableAction("redo", canRedo);
  enableAction("reset-selection", canResetSelection);
  enableAction("reset", entryCount > 0);
  byId("history-empty", HTMLParagraphElement).hidden = entryCount > 0;
  const entries = bench.answer((studio) => studio.latestEntries(LISTED));
  const rows = entries.map((entry) => row(entry, bench)).reverse();
  for (const entry of entries) entry.free();
  if (entryCount > entries.length) rows.push(make("li", "earlier", say("history.earlier", { n: entryCount - entries.length })));
  byId("history", HTMLOListElement).replaceChildren(...rows);
}

/**
 * One edit: what it changed and how much, and whether it takes part.
 *
 * @param {StudioEntry} entry
 * @param {Workbench} bench
 */
function row({ index, target, amount, unit, enabled, waitsForDensity, impossible }, bench) {
  const name = sayOnce(target) ?? "";
  const item = make("li");
  item.toggleAttribute("data-off", !enabled || impossible);
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
    const key = `density.${waitsForDensity}`;
    item.append(make("span", "waits", say("history.waits", { density: isWord(key) ? say(key) : "" })));
  }
  if (impossible) item.append(make("span", "waits", say("history.impossible")));
  return item;
}
