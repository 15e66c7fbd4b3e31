import { readFile } from "node:fs/promises";
import fc from "fast-check";
import { faceless, text, twice } from "../pictures.mjs";
import { SAMPLE } from "../visitor.mjs";
import { CHECKS } from "./checks.mjs";
import { gesture, play, share } from "./pointer.mjs";

/**
 * @typedef {import("./visit.mjs").Visit} Visit
 * @typedef {import("./page.mjs").Seen} Seen
 */

const NUMBERS = ["0", "1", "-1", "5", "-7.5", "12", "-25", "100", "1e308", "-1e308", "1e-320", "-0", "", "e", "--", "999999999", "abc", "٣", "1,5", "+3", "007"];
const TEXTS = ["nose tip", "bottom of the chin", "left", "61", "1", "0", "467", "468", "7585", "28880", "-1", "1.5", "1e9", "", "   ", "ponta do nariz", "😀", "<b>", "nowhere", "10", "152", "33"];
const FIELD_KEYS = ["Enter", "Tab", "Escape", "ArrowUp"];
const SLIDER_KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown", "Escape"];
/** Every key that the page listens to, and a few that it does not. */
const KEYS = [
  ...SLIDER_KEYS, "Alt+ArrowUp", "Alt+ArrowDown", "Control+Shift+ArrowLeft", "Control+Shift+ArrowUp", "Shift+ArrowLeft", "f", "l", "t", "w", "b", "p",
  "x", "y", "z", "Space", "Enter", "Tab", "Shift+Tab", "?", "Control+z", "Control+Shift+z", "Control+y", "Delete", "q", "1",
];
const SIZES = [[760, 480], [1024, 640], [390, 700], [280, 300], [719, 500], [900, 240]].map(([width, height]) => ({ width, height }));
const MEDIA = [{ colorScheme: "light" }, { colorScheme: "dark" }, { reducedMotion: "reduce" }, { reducedMotion: "no-preference" }];
const UNDOING = ["undo", "undo", "undo", "redo", "redo", "reset", "reset-selection"];

/** A file's bytes; none if it was not downloaded yet. @type {Record<string, (visit: Visit) => Promise<Uint8Array | undefined> | Uint8Array | undefined>} */
const FILES = {
  "portrait.png": () => readFile(SAMPLE),
  "friends.png": async ({ page }) => twice(page, await readFile(SAMPLE)),
  "wall.png": faceless,
  "half.png": async () => half(await readFile(SAMPLE)),
  "diary.jpg": text,
  "diary.glb": () => Buffer.concat([Buffer.from("glTF"), text()]),
  "diary.rosto": () => Buffer.concat([Buffer.from('{"format":"rosto-project","version":1}\n'), text()]),
  "face.glb": ({ downloads }) => downloads.get("glb"),
  "face.rosto": ({ downloads }) => downloads.get("rosto"),
  "half.glb": ({ downloads }) => half(downloads.get("glb")),
  "half.rosto": ({ downloads }) => half(downloads.get("rosto")),
};

const free = (/** @type {Seen} */ { dialog }) => !dialog;
const withFace = (/** @type {Seen} */ { dialog, state }) => !dialog && state === "face";
const beforeFace = (/** @type {Seen} */ { dialog, state, busy }) => !dialog && !busy && state !== "face";

const several = (/** @type {readonly string[]} */ values, maxLength = 4) => fc.array(fc.constantFrom(...values), { minLength: 1, maxLength });
const control = { group: share, control: share };

/** Anything that a visitor can do. */
export const action = fc.oneof(
  weighted(25, "arrive", beforeFace, { resumes: fc.boolean() }, arrive),
  weighted(36, "use", () => true, { ...control, value: share, keys: several(SLIDER_KEYS, 6), last: share }, use),
  weighted(8, "shuffle", withFace, { picks: fc.array(fc.record({ control: share, value: share }), { minLength: 2, maxLength: 5 }) }, ({ page }, { picks }) => page.evaluate((picks) => window["monkey"].shuffle(picks), picks)),
  weighted(24, "view", free, { moves: gesture }, (visit, { moves }) => play(visit, "#viewport", moves)),
  weighted(4, "photo", withFace, { moves: gesture }, (visit, { moves }) => play(visit, "#photo-picture", moves)),
  weighted(9, "keys", () => true, { keys: several(KEYS), isOnView: fc.boolean() }, press),
  weighted(3, "files", free, { names: several(Object.keys(FILES), 3), by: fc.constantFrom("drop", "drop", "paste"), waits: fc.boolean() }, bring),
  weighted(2, "resize", free, { size: fc.constantFrom(...SIZES) }, ({ page }, { size }) => page.setViewportSize(size)),
  weighted(4, "undo storm", withFace, { presses: several(UNDOING, 20) }, storm),
  weighted(1, "media", free, { media: fc.constantFrom(...MEDIA) }, ({ page }, { media }) => page.emulateMedia(media)),
  weighted(1, "reload", free, { resumes: fc.boolean() }, reload),
  weighted(3, "check", withFace, { what: fc.constantFrom("undo and redo", "undo and redo", "history", "GLB", "reload") }, (visit, { what }) => CHECKS[what](visit)),
);

/**
 * A fast-check command, drawn as often as its weight. Its text names what it met.
 *
 * @template T
 * @param {number} weight
 * @param {string} name
 * @param {(seen: Seen) => boolean} applies
 * @param {{ [K in keyof T]: fc.Arbitrary<T[K]> }} how
 * @param {(visit: Visit, how: T) => unknown} act may return what it met
 */
function weighted(weight, name, applies, how, act) {
  const command = (/** @type {T} */ values) => {
    let met = "";
    return {
      check: (/** @type {Visit} */ { seen }) => applies(seen),
      run: (/** @type {Visit} */ visit) => visit.perform(async () => {
        met = String((await act(visit, values)) ?? "");
      }),
      toString: () => `\n  ${name} ${met} ${JSON.stringify(values)}`,
    };
  };
  return { weight, arbitrary: fc.record(how).map(command) };
}

/** @param {Visit} visit @param {{ resumes: boolean }} how */
async function arrive(visit, { resumes }) {
  if (resumes && (await visit.press("#continue:not([hidden])"))) return;
  await bring(visit, { names: ["portrait.png"], by: "drop", waits: true });
}

/** @param {Visit} visit @param {{ group: number, control: number, value: number, keys: string[], last: number }} how */
async function use({ page }, { value, keys, last, ...which }) {
  const chosen = await page.evaluate((which) => window["monkey"].choose(which), which);
  if (!chosen) return "nothing";
  const { kind, label, x, y, width, height } = chosen;
  const across = (/** @type {number} */ share) => x + 8 + share * (width - 16);
  if (kind === "select" || kind === "color") await page.evaluate((value) => window["monkey"].set(value), value);
  else if (kind === "number" || kind === "text" || kind === "search") await enter(page, at(kind === "number" ? NUMBERS : TEXTS, value), at([...FIELD_KEYS, ""], last));
  else if (kind === "range" && last < 0.5) await enter(page, undefined, ...keys);
  else if (kind === "range") await dragTo(page, { x: across(value), y: y + height / 2 }, across(2 * last - 1));
  else await page.mouse.click(x + width / 2, y + height / 2, { clickCount: kind === "label" ? 2 : 1 });
  return `${kind} “${label}”`;
}

/** @param {import("@playwright/test").Page} page @param {string | undefined} text @param {string[]} keys */
async function enter(page, text, ...keys) {
  await page.evaluate(() => window["monkey"].enter());
  if (text === "") await page.keyboard.press("Delete");
  else if (text) await page.keyboard.insertText(text);
  for (const key of keys.filter(Boolean)) await page.keyboard.press(key);
}

/** @param {import("@playwright/test").Page} page @param {{ x: number, y: number }} from @param {number} x */
async function dragTo({ mouse }, from, x) {
  await mouse.move(from.x, from.y);
  await mouse.down();
  await mouse.move(x, from.y, { steps: 3 });
  await mouse.up();
}

/** @param {Visit} visit @param {{ keys: string[], isOnView: boolean }} how */
async function press({ page }, { keys, isOnView }) {
  if (isOnView) await page.evaluate(() => document.getElementById("viewport").focus());
  for (const key of keys) await page.keyboard.press(key);
}

/** @param {Visit} visit @param {{ names: string[], by: "drop" | "paste", waits: boolean }} how */
async function bring(visit, { names, by, waits }) {
  for (const name of names) {
    const bytes = await FILES[name](visit);
    if (bytes) await visit.page.evaluate((file) => window["monkey"].bring(file), { name, by, base64: Buffer.from(bytes).toString("base64") });
  }
  if (waits) await visit.untilQuiet();
}

/** Undo and redo faster than the page draws. @param {Visit} visit @param {{ presses: string[] }} how */
function storm({ page }, { presses }) {
  return page.evaluate((presses) => {
    for (const action of presses) window["monkey"].press(`#section-history [data-action="${action}"]`);
  }, presses);
}

/** @param {Visit} visit @param {{ resumes: boolean }} how */
async function reload(visit, { resumes }) {
  await visit.page.reload();
  if (resumes) await visit.resume(3_000);
}

/** @template T @param {readonly T[]} values @param {number} share */
function at(values, share) {
  return values[Math.floor(share * values.length)];
}

/** @param {Uint8Array | undefined} bytes */
function half(bytes) {
  return bytes?.subarray(0, bytes.length / 2);
}
