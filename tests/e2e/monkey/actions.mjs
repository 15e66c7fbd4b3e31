import { readFile } from "node:fs/promises";
import fc from "fast-check";
import { faceless, text, twice } from "../pictures.mjs";
import { SAMPLE } from "../visitor.mjs";
import { check } from "./checks.mjs";
import { gesture, often, play, share } from "./pointer.mjs";

/**
 * @typedef {import("./visit.mjs").Visit} Visit
 * @typedef {import("./page.mjs").Seen} Seen
 */

const ODD = ["-0", "", "e", "--", "abc", "٣", "1,5", "+3", "007"];
const number = fc.oneof(fc.integer({ min: -30, max: 30 }), fc.double(), fc.constantFrom(...ODD));
const SOUGHT = ["nose tip", "bottom of the chin", "left", "ponta do nariz", "", "   ", "-1", "1.5", "1e9", "467", "468", "<b>"];
const words = fc.oneof(fc.constantFrom(...SOUGHT), fc.nat(30_000), fc.string({ unit: "grapheme" }));
const SLIDER_KEYS = ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home", "End", "PageUp", "PageDown", "Escape"];
/** Keys that the page handles, and a few that it does not. */
const KEYS = [
  ...SLIDER_KEYS, "Alt+ArrowUp", "Alt+ArrowDown", "Control+Shift+ArrowLeft", "Control+Shift+ArrowUp", "Shift+ArrowLeft", "f", "l", "t",
  "w", "b", "p", "x", "y", "z", "Space", "Enter", "Tab", "Shift+Tab", "?", "Control+z", "Control+Shift+z", "Control+y", "Delete", "q", "1",
];
const SIZES = [[760, 480], [1024, 640], [390, 700], [280, 300], [719, 500], [900, 240]].map(([width, height]) => ({ width, height }));
const MEDIA = [{ colorScheme: "light" }, { colorScheme: "dark" }, { reducedMotion: "reduce" }, { reducedMotion: "no-preference" }];
const UNDOING = ["undo", "undo", "undo", "redo", "redo", "reset", "reset-selection"];

/** Bytes of a file; undefined if it has not been downloaded yet. */
const FILES = {
  "portrait.png": () => readFile(SAMPLE),
  "friends.png": async ({ page }) => twice(page, await readFile(SAMPLE)),
  "wall.png": faceless,
  "diary.jpg": text,
  "diary.glb": () => Buffer.concat([Buffer.from("glTF"), text()]),
  "diary.rosto": () => Buffer.concat([Buffer.from('{"format":"rosto-project","version":1}\n'), text()]),
  "face.glb": ({ downloads }) => downloads.get(".glb"),
  "face.rosto": ({ downloads }) => downloads.get(".rosto"),
};

const always = () => true;
const free = ({ dialog }) => !dialog;
const withFace = ({ dialog, state }) => !dialog && state === "face";
const beforeFace = ({ dialog, state, busy }) => !dialog && !busy && state !== "face";

const several = (values, maxLength = 4) => fc.array(fc.constantFrom(...values), { minLength: 1, maxLength });
const resumes = fc.boolean();
const how = {
  number: number.map(String),
  text: words.map(String),
  leaving: fc.constantFrom("Enter", "Tab", "Escape", "ArrowUp", undefined),
  keys: several(SLIDER_KEYS, 6),
};
const on = often([6, fc.constant("#viewport")], [1, fc.constant("#photo-picture")]);
const picks = fc.array(fc.record({ control: share, value: share }), { minLength: 2, maxLength: 5 });
const file = fc.record({ name: fc.constantFrom(...Object.keys(FILES)), part: fc.constantFrom(1, 1, 0.5) });
const files = { files: fc.array(file, { minLength: 1, maxLength: 3 }), by: fc.constantFrom("drop", "drop", "paste"), waits: fc.boolean() };
const checked = fc.constantFrom("undo and redo", "undo and redo", "history", "GLB", "reload");

/** A random user action. */
export const action = often(
  [25, command("arrive", beforeFace, { resumes }, arrive)],
  [36, command("use", always, { group: share, control: share, from: share, to: fc.option(share, { freq: 2 }), ...how }, use)],
  [8, command("shuffle", withFace, { picks }, ({ page }, { picks }) => page.evaluate((picks) => window["monkey"].shuffle(picks), picks))],
  [28, command("point", free, { on, moves: gesture }, (visit, { on, moves }) => play(visit, on, moves))],
  [9, command("keys", always, { keys: several(KEYS), isOnView: fc.boolean() }, press)],
  [3, command("files", free, files, bring)],
  [2, command("resize", free, { size: fc.constantFrom(...SIZES) }, ({ page }, { size }) => page.setViewportSize(size))],
  [4, command("undo storm", withFace, { presses: several(UNDOING, 20) }, storm)],
  [1, command("media", free, { media: fc.constantFrom(...MEDIA) }, ({ page }, { media }) => page.emulateMedia(media))],
  [1, command("reload", free, { resumes }, reload)],
  [3, command("check", withFace, { what: checked }, (visit, { what }) => check(visit, what))],
);

/**
 * An action of the model-based test. Its text includes what it acted on.
 *
 * @template T
 * @param {string} name
 * @param {(seen: Seen) => boolean} applies
 * @param {{ [K in keyof T]: fc.Arbitrary<T[K]> }} how
 * @param {(visit: Visit, how: T) => unknown} act may return what it acted on
 */
function command(name, applies, how, act) {
  return fc.record(how).map((values) => {
    let met = "";
    return {
      check: ({ seen }) => applies(seen),
      run: (visit) => visit.perform(async () => {
        met = String((await act(visit, values)) ?? "");
      }),
      toString: () => `\n  ${name} ${met} ${JSON.stringify(values)}`,
    };
  });
}

/** @param {Visit} visit @param {{ resumes: boolean }} how */
async function arrive(visit, { resumes }) {
  if (resumes && (await visit.press("#continue:not([hidden])"))) return;
  await bring(visit, { files: [{ name: "portrait.png", part: 1 }], by: "drop", waits: true });
}

/** Uses a control according to its kind; a slider by keys or, with `to`, by a drag. @param {Visit} visit */
async function use({ page }, { group, control, from, to, number, text, leaving, keys }) {
  const chosen = await page.evaluate((which) => window["monkey"].choose(which), { group, control });
  if (!chosen) return "nothing";
  const { kind, label, box } = chosen;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const across = (share) => box.x + 8 + share * (box.width - 16);
  if (kind === "select" || kind === "color") await page.evaluate((value) => window["monkey"].set(value), from);
  else if (kind === "number") await enter(page, number, leaving);
  else if (kind === "text" || kind === "search") await enter(page, text, leaving);
  else if (kind === "range" && to === null) await enter(page, undefined, ...keys);
  else if (kind === "range") {
    await page.mouse.move(across(from), y);
    await page.mouse.down();
    await page.mouse.move(across(to), y, { steps: 3 });
    await page.mouse.up();
  } else await page.mouse.click(x, y, { clickCount: kind === "label" ? 2 : 1 });
  return `${kind} “${label}”`;
}

/**
 * @param {import("@playwright/test").Page} page
 * @param {string | undefined} text
 * @param {(string | undefined)[]} keys
 */
async function enter(page, text, ...keys) {
  await page.evaluate(() => window["monkey"].enter());
  if (text === "") await page.keyboard.press("Delete");
  else if (text) await page.keyboard.insertText(text);
  for (const key of keys) if (key) await page.keyboard.press(key);
}

/** @param {Visit} visit @param {{ keys: string[], isOnView: boolean }} how */
async function press({ page }, { keys, isOnView }) {
  if (isOnView) await page.evaluate(() => document.getElementById("viewport").focus());
  for (const key of keys) await page.keyboard.press(key);
}

/** Drops or pastes files, possibly truncated. @param {Visit} visit */
async function bring(visit, { files, by, waits }) {
  for (const { name, part } of files) {
    const bytes = await FILES[name](visit);
    const base64 = bytes?.subarray(0, part * bytes.length).toString("base64");
    if (base64) await visit.page.evaluate((file) => window["monkey"].bring(file), { name, by, base64 });
  }
  if (waits) await visit.untilQuiet();
}

/** Triggers undo and redo faster than the page draws. @param {Visit} visit @param {{ presses: string[] }} how */
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
