/**
 * What a restless visitor does next.
 *
 * @typedef {import("./eyes.mjs").Seen} Seen
 * @typedef {import("./eyes.mjs").Control} Control
 * @typedef {import("./chance.mjs").Chance} Chance
 *
 * @typedef {{ type: "down" | "up" | "move" | "cancel" | "wheel" | "key" | "pause" | "fingers", x?: number, y?: number, button?: "left" | "right" | "middle", held?: number, dy?: number, key?: string, places?: { x: number, y: number }[] }} Move
 *   places are shares of the picture's width and height; `held` are the modifiers, as the browser's protocol counts them
 *
 * @typedef {{ do: "press" | "doublePress", at: string, label: string }
 *   | { do: "set", at: string, label: string, value: string | number }
 *   | { do: "enter", at: string, label: string, text: string, lastKey: string | null }
 *   | { do: "slide", at: string, label: string, keys: string[] }
 *   | { do: "pull", at: string, label: string, from: number, to: number }
 *   | { do: "pointer", on: "view" | "photo", how: string, moves: Move[] }
 *   | { do: "keys", keys: string[], focus: boolean }
 *   | { do: "files", files: string[], by: "drop" | "paste", wait: boolean }
 *   | { do: "storm", presses: string[] }
 *   | { do: "shuffle", choices: { at: string, label: string, value: string | number | null }[] }
 *   | { do: "resize", width: number, height: number }
 *   | { do: "media", media: { colorScheme?: "light" | "dark", reducedMotion?: "reduce" | "no-preference" } }
 *   | { do: "reload", goOn: boolean }
 *   | { do: "check", what: "undo-redo" | "history" | "glb" | "reload" }} Action
 */

const ALT = 1;
const CTRL = 2;
const SHIFT = 8;
const HELD = [[12, 0], [3, SHIFT], [3, ALT], [1, CTRL], [1, SHIFT | ALT]];

/** What is typed where a number is asked for. */
const NUMBERS = ["0", "1", "-1", "5", "-7.5", "12", "25", "-25", "100", "1e308", "-1e308", "1e-320", "-0", "", "e", "--", "0.1", "999999999", "abc", "٣", "1,5", "+3", "007"];

/** What is typed where a landmark is asked for. */
const TEXTS = ["nose tip", "bottom of the chin", "left", "61", "1", "0", "467", "468", "7585", "28880", "-1", "1.5", "1e9", "", "   ", "ponta do nariz", "😀", "<b>", "nobody knows this place", "10", "152", "33"];

/** Every key that the page listens to, and a few that it does not. */
const KEYS = [
  "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Alt+ArrowUp", "Alt+ArrowDown", "Control+Shift+ArrowLeft", "Control+Shift+ArrowUp", "Shift+ArrowLeft",
  "f", "l", "t", "w", "b", "p", "x", "y", "z", "Space", "Escape", "Enter", "Tab", "Shift+Tab", "?", "Control+z", "Control+Shift+z", "Control+y", "Home", "End", "PageUp", "PageDown", "Delete", "q", "1",
];
const SLIDER_KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown", "Escape"];
const DRAG_KEYS = ["Escape", "x", "y", "z", "x", "Control+z", "w", "b", "Tab"];

const SIZES = [
  [6, [760, 480]],
  [2, [1024, 640]],
  [2, [390, 700]],
  [1, [280, 300]],
  [1, [719, 500]],
  [1, [900, 240]],
];

/** The files at hand from the start; what was downloaded in this visit comes with them. */
const FILES = [[5, "portrait"], [1, "two faces"], [1, "no face"], [1, "damaged picture"], [1, "text"], [1, "text called GLB"], [1, "text called project"], [3, "GLB"], [1, "half a GLB"], [3, "project"], [1, "half a project"]];

/** What takes long is done less often. */
const SHARE_OF_SLOW = { "run-paper": 0.15, camera: 0.4, "close-camera": 0.5 };

/** Most of the time goes into shaping. */
const SHUFFLED = new Set(["section-landmark", "section-view", "section-history"]);
const SHARE_OF_GROUP = { "section-landmark": 4, "section-view": 1.5, "section-history": 1.5 };

/**
 * @param {Chance} chance
 * @param {Seen} seen
 * @returns {Action}
 */
export function wish(chance, seen) {
  if (seen.dialog) return chance.is(0.7) ? useControl(chance, seen) : anyKeys(chance);
  if (seen.state !== "face" && !seen.busy) return beforeTheFace(chance, seen);
  const wishes = /** @type {const} */ ([
    [36, useControl],
    [8, shuffle],
    [24, onTheView],
    [4, onThePhoto],
    [9, anyKeys],
    [3, bringFiles],
    [2, resize],
    [4, storm],
    [0.7, reload],
    [0.6, media],
    [2.5, check],
  ]);
  return chance.weighted(wishes)(chance, seen);
}

/**
 * Most who arrive open a photo, or go on.
 *
 * @param {Chance} chance
 * @param {Seen} seen
 */
function beforeTheFace(chance, seen) {
  const goOn = seen.controls.find(({ at }) => at === "#continue");
  if (goOn && chance.is(0.5)) return press(goOn);
  if (chance.is(0.45)) return /** @type {Action} */ ({ do: "files", files: ["portrait"], by: "drop", wait: true });
  return chance.weighted(/** @type {const} */ ([[4, useControl], [2, onTheView], [1, anyKeys], [2, bringFiles], [1, resize], [0.3, reload]]))(chance, seen);
}

/**
 * Something of any part of the page, so that a part with many controls is not used more than the others.
 *
 * @param {Chance} chance
 * @param {Seen} seen
 * @returns {Action}
 */
function useControl(chance, seen) {
  const groups = [...new Set(seen.controls.map(({ group }) => group))];
  if (groups.length === 0) return anyKeys(chance);
  const group = chance.weighted(groups.map((name) => [SHARE_OF_GROUP[name] ?? 1, name]));
  const control = chance.weighted(seen.controls.filter((one) => one.group === group).map((one) => [shareOf(one), one]));
  if (!chance.is(SHARE_OF_SLOW[control.action] ?? 1)) return anyKeys(chance);
  return use(chance, control);
}

/**
 * Several choices at once, faster than the page draws: modes meet that rarely meet otherwise.
 *
 * @param {Chance} chance
 * @param {Seen} seen
 * @returns {Action}
 */
function shuffle(chance, seen) {
  const choosable = seen.controls.filter(({ kind, group }) => (kind === "select" || kind === "tick") && SHUFFLED.has(group));
  if (choosable.length === 0) return useControl(chance, seen);
  const choices = several(chance, 2, 5, () => {
    const { at, label, kind, options } = chance.weighted(choosable.map((one) => [one.kind === "select" ? 3 : 1, one]));
    return { at, label, value: kind === "select" ? chooseOption(chance, at, options) : null };
  });
  return { do: "shuffle", choices };
}

/** What decides how the face follows is tried most, and folds stay open more often than not. @param {Control} control */
function shareOf({ kind, open }) {
  if (kind === "fold") return open ? 0.2 : 4;
  return kind === "select" ? 3 : kind === "tick" ? 1.5 : 1;
}

/**
 * @param {Chance} chance
 * @param {Control} control
 * @returns {Action}
 */
function use(chance, control) {
  const { at, label, kind, options } = control;
  if (kind === "select") return { do: "set", at, label, value: chooseOption(chance, at, options) };
  if (kind === "colour") return { do: "set", at, label, value: `#${chance.below(0x1000000).toString(16).padStart(6, "0")}` };
  if (kind === "label") return { do: "doublePress", at, label };
  if (kind === "number") return { do: "enter", at, label, text: chance.one(NUMBERS), lastKey: chance.one(["Tab", "Enter", "Escape", null, "ArrowUp"]) };
  if (kind === "text") return { do: "enter", at, label, text: chance.one(TEXTS), lastKey: chance.one(["Enter", "Enter", "Tab", "Escape", null]) };
  if (kind !== "range") return press(control);
  if (chance.is(0.5)) return { do: "pull", at, label, from: chance.next(), to: chance.next() };
  return { do: "slide", at, label, keys: several(chance, 1, 6, () => chance.one(SLIDER_KEYS)) };
}

/** @param {Control} control @returns {Action} */
function press({ at, label }) {
  return { do: "press", at, label };
}

/**
 * The dense meshes, which a software GPU draws slowly, come up less often.
 *
 * @param {Chance} chance
 * @param {string} at
 * @param {number} options
 */
function chooseOption(chance, at, options) {
  if (!at.includes("density") || options < 4) return chance.below(options);
  return chance.weighted([[8, 0], [5, 1], [1, 2], [0.3, 3]]);
}

/** @param {Chance} chance @returns {Action} */
function onTheView(chance) {
  const [how, moves] = chance.weighted(/** @type {const} */ ([[6, drag], [4, click], [2, hover], [2, wheel], [1.5, pinch], [1, touch]]))(chance);
  return { do: "pointer", on: "view", how, moves };
}

/** @param {Chance} chance @param {Seen} seen @returns {Action} */
function onThePhoto(chance, seen) {
  if (!seen.photo) return onTheView(chance);
  const [how, moves] = chance.weighted(/** @type {const} */ ([[4, click], [3, drag], [2, hover], [1, wheel]]))(chance);
  return { do: "pointer", on: "photo", how, moves };
}

/** Most places are on the face, in the middle. @param {Chance} chance */
function place(chance) {
  const spread = chance.is(0.8) ? 0.25 : 0.5;
  return { x: 0.5 + chance.between(-spread, spread), y: 0.5 + chance.between(-spread, spread) };
}

/** @param {Chance} chance @returns {[string, Move[]]} */
function click(chance) {
  const at = { ...place(chance), button: chance.weighted([[8, "left"], [1, "right"], [0.5, "middle"]]), held: chance.weighted(HELD) };
  const moves = [{ type: "move", ...at }, { type: "down", ...at }, { type: "up", ...at }];
  return ["click", /** @type {Move[]} */ (moves)];
}

/** A drag, with whatever can come in its middle. @param {Chance} chance @returns {[string, Move[]]} */
function drag(chance) {
  const button = chance.weighted([[9, "left"], [1, "right"], [0.3, "middle"]]);
  const held = chance.weighted(HELD);
  const [from, to] = [place(chance), place(chance)];
  /** @type {Move[]} */
  const moves = [{ type: "move", ...from, held }, { type: "down", ...from, button, held }];
  const steps = 2 + chance.below(5);
  for (let step = 1; step <= steps; step++) {
    const share = step / steps;
    moves.push({ type: "move", x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y), button, held });
    if (chance.is(0.12)) moves.push({ type: "key", key: chance.one(DRAG_KEYS) });
    if (chance.is(0.06)) moves.push({ type: "wheel", ...to, dy: chance.between(-600, 600) });
    if (chance.is(0.03)) moves.push({ type: "cancel" });
  }
  moves.push({ type: "up", ...to, button, held });
  return ["drag", moves];
}

/** @param {Chance} chance @returns {[string, Move[]]} */
function hover(chance) {
  return ["hover", several(chance, 1, 5, () => ({ type: "move", ...place(chance) }))];
}

/** @param {Chance} chance @returns {[string, Move[]]} */
function wheel(chance) {
  return ["wheel", several(chance, 1, 4, () => ({ type: "wheel", ...place(chance), dy: chance.one([-3000, -400, -100, 100, 400, 3000]), held: chance.weighted([[5, 0], [1, CTRL]]) }))];
}

/** @param {Chance} chance @returns {[string, Move[]]} */
function pinch(chance) {
  /** @type {Move[]} */
  const moves = several(chance, 2, 5, () => ({ type: "fingers", places: [place(chance), place(chance)] }));
  return ["pinch", [...moves, lift(chance)]];
}

/** @param {Chance} chance @returns {[string, Move[]]} */
function touch(chance) {
  /** @type {Move[]} */
  const moves = several(chance, 1, 4, () => ({ type: "fingers", places: [place(chance)] }));
  if (chance.is(0.3)) moves.splice(1, 0, { type: "pause" });
  return ["touch", [...moves, lift(chance)]];
}

/** @param {Chance} chance @returns {Move} */
function lift(chance) {
  return chance.is(0.2) ? { type: "cancel" } : { type: "fingers", places: [] };
}

/** @param {Chance} chance @returns {Action} */
function anyKeys(chance) {
  return { do: "keys", keys: several(chance, 1, 4, () => chance.one(KEYS)), focus: chance.is(0.6) };
}

/** @param {Chance} chance @returns {Action} */
function bringFiles(chance) {
  const files = several(chance, 1, chance.is(0.3) ? 3 : 1, () => chance.weighted(FILES));
  return { do: "files", files, by: chance.is(0.8) ? "drop" : "paste", wait: chance.is(0.6) };
}

/** Undo and redo faster than anybody looks. @param {Chance} chance @returns {Action} */
function storm(chance) {
  return { do: "storm", presses: several(chance, 3, 20, () => chance.weighted([[5, "undo"], [4, "redo"], [0.3, "reset"], [0.3, "reset-selection"]])) };
}

/** @param {Chance} chance @returns {Action} */
function resize(chance) {
  const [width, height] = chance.weighted(SIZES);
  return { do: "resize", width, height };
}

/** @param {Chance} chance @returns {Action} */
function media(chance) {
  return { do: "media", media: chance.one([{ colorScheme: "light" }, { colorScheme: "dark" }, { reducedMotion: "reduce" }, { reducedMotion: "no-preference" }]) };
}

/** @param {Chance} chance @returns {Action} */
function reload(chance) {
  return { do: "reload", goOn: chance.is(0.7) };
}

/** @param {Chance} chance @returns {Action} */
function check(chance) {
  return { do: "check", what: chance.weighted([[4, "undo-redo"], [2, "history"], [1, "glb"], [1.5, "reload"]]) };
}

/**
 * @template T
 * @param {Chance} chance
 * @param {number} least
 * @param {number} most
 * @param {() => T} make
 * @returns {T[]}
 */
function several(chance, least, most, make) {
  return Array.from({ length: least + chance.below(most - least + 1) }, make);
}
