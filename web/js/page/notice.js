import { inEveryLanguage, isWord, say } from "../words/words.js";
import { byId } from "./dom.js";
import { asPageError } from "./page-error.js";

/**
 * @typedef {"one-of-several" | "adds-little" | "earlier-work"} Remark
 * @typedef {{ kind: "error" | "remark", code: string, words: () => { title: string, hint: string } }} Notice
 */

/** @type {Notice | undefined} */
let shown;
/** Whether this browser keeps the work from one visit to the next. */
let keeps = true;

/** Shows notices in the page's language and lets them be closed. */
export function setUpNotice() {
  byId("notice-close", HTMLButtonElement).addEventListener("click", () => hideNotice());
  addEventListener("keydown", ({ key }) => {
    if (key === "Escape") hideNotice();
  });
  inEveryLanguage(write);
}

/**
 * Says what happened, and what to do next.
 *
 * @param {unknown} thrown
 */
export function showError(thrown) {
  show(noticeOf(thrown));
}

/**
 * Says something that is no error.
 *
 * @param {Remark} remark
 * @param {Record<string, string | number>} values for its words
 */
export function showRemark(remark, values) {
  const words = () => ({ title: say(`remark.${remark}`, values), hint: say(`remark.${remark}.hint`, values) });
  show({ kind: "remark", code: remark, words });
}

/**
 * Says that a file was not added to those that are there, why, and what to do next.
 *
 * @param {string} name of the file
 * @param {unknown} thrown
 */
export function showNotAdded(name, thrown) {
  const notice = noticeOf(thrown);
  const words = () => {
    const { title: reason, hint: usual } = notice.words();
    // A face from the side does not look at the camera.
    const hint = notice.code === "no-face-found" ? say("photos.not-added.no-face") : usual;
    return { title: say("photos.not-added", { name }), hint: say("photos.not-added.why", { reason, hint }) };
  };
  show({ ...notice, words });
}

/** Takes the notice away. */
export function hideNotice() {
  show(undefined);
}

/**
 * Notices promise that work is kept only where that is so.
 *
 * @param {boolean} isKept
 */
export function setKeeping(isKept) {
  keeps = isKept;
  write();
}

/** @param {Notice | undefined} notice */
function show(notice) {
  shown = notice;
  write();
}

/**
 * What was not foreseen is told to the console as well.
 *
 * @param {unknown} thrown
 * @returns {Notice}
 */
function noticeOf(thrown) {
  const { code } = asPageError(thrown);
  if (code === "other" || !isWord(`error.${code}`)) console.error(thrown);
  return { kind: "error", code, words: () => wordsFor(code) };
}

function write() {
  const notice = byId("notice", HTMLDivElement);
  notice.hidden = shown === undefined;
  if (!shown) return;
  const { title, hint } = shown.words();
  notice.dataset["kind"] = shown.kind;
  notice.dataset["code"] = shown.code;
  byId("notice-title", HTMLParagraphElement).textContent = title;
  byId("notice-hint", HTMLParagraphElement).textContent = hint;
}

/**
 * The page's own words: what the modules say is English, and for those who develop them.
 *
 * @param {string} code
 */
function wordsFor(code) {
  const key = `error.${code}`;
  const known = isWord(key) ? key : "error.other";
  return { title: say(known), hint: say(hintOf(known)) };
}

/**
 * @param {string} key of an error's words
 * @returns {import("../words/words.js").WordKey}
 */
function hintOf(key) {
  const hint = `${key}.hint`;
  const unkept = `${hint}.unkept`;
  if (!keeps && isWord(unkept)) return unkept;
  return isWord(hint) ? hint : "error.other.hint";
}
