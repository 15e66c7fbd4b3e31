import { onLocaleChange, isWord, t } from "../words/words.js";
import { byId } from "./dom.js";
import { asPageError } from "./page-error.js";

/**
 * @typedef {"one-of-several" | "adds-little" | "earlier-work" | "may-not-be-a-face"} Remark
 * @typedef {{ kind: "error" | "remark", code: string, words: () => { title: string, hint: string } }} Notice
 * @typedef {"page" | "studio" | "gpu"} Owner who shows a notice, and alone may take it away again
 */

/** The notice of each owner, the latest last: that is the one that shows. @type {Map<Owner, Notice>} */
const notices = new Map();
/** Whether this browser keeps the work from one visit to the next. */
let keeps = true;

/** Shows notices in the page's language and lets them be closed. */
export function setUpNotice() {
  byId("notice-close", HTMLButtonElement).addEventListener("click", () => dismissNotices());
  addEventListener("keydown", ({ key }) => {
    if (key === "Escape") dismissNotices();
  });
  for (const change of ["toggle", "close"]) addEventListener(change, ({ target }) => target instanceof HTMLDialogElement && write(), { capture: true });
  onLocaleChange(write);
}

/**
 * Says what happened, and what to do next.
 *
 * @param {unknown} thrown
 * @param {Owner} [owner]
 */
export function showError(thrown, owner = "page") {
  show(noticeOf(thrown), owner);
}

/**
 * Says something that is no error.
 *
 * @param {Remark} remark
 * @param {Record<string, string | number>} values for its words
 */
export function showRemark(remark, values) {
  const words = () => ({ title: t(`remark.${remark}`, values), hint: t(`remark.${remark}.hint`, values) });
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
    const hint = notice.code === "no-face-found" ? t("photos.not-added.no-face") : usual;
    return { title: t("photos.not-added", { name }), hint: t("photos.not-added.why", { reason, hint }) };
  };
  show({ ...notice, words });
}

/**
 * Takes an owner's notice away; what another one shows stays.
 *
 * @param {Owner} owner
 */
export function hideNotice(owner) {
  notices.delete(owner);
  write();
}

/** The visitor has read what is shown, or begins something new. */
export function dismissNotices() {
  notices.clear();
  write();
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

/**
 * @param {Notice} notice
 * @param {Owner} [owner]
 */
function show(notice, owner = "page") {
  notices.delete(owner);
  notices.set(owner, notice);
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
  const shown = [...notices.values()].at(-1);
  notice.hidden = shown === undefined;
  place(notice);
  if (!shown) return;
  const { title, hint } = shown.words();
  notice.dataset["kind"] = shown.kind;
  notice.dataset["code"] = shown.code;
  byId("notice-title", HTMLParagraphElement).textContent = title;
  byId("notice-hint", HTMLParagraphElement).textContent = hint;
}

/** Where the notice is while no dialog is open. @type {Comment | undefined} */
let home;

/**
 * Above a dialog that is open, and within it: what is outside cannot be pressed.
 *
 * @param {HTMLElement} notice
 */
function place(notice) {
  if (!home) {
    home = document.createComment("notice");
    notice.before(home);
  }
  const dialog = [...document.querySelectorAll("dialog:modal")].at(-1);
  if (dialog && !notice.hidden) {
    if (notice.parentElement === dialog) return;
    dialog.append(notice);
    notice.popover = "manual";
    notice.showPopover();
  } else if (notice.popover) {
    notice.popover = null;
    home.after(notice);
  }
}

/**
 * The page's own words: what the modules say is English, and for those who develop them.
 *
 * @param {string} code
 */
function wordsFor(code) {
  const key = `error.${code}`;
  const known = isWord(key) ? key : "error.other";
  return { title: t(known), hint: t(hintOf(known)) };
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
