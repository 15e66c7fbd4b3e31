import { isWord, onLocaleChange, t } from "../words/words.ts";
import { byId } from "./dom.ts";
import { asPageError } from "./page-error.ts";
import type { PhotoRemark } from "../../wasm/rosto-vision-web.js";

type Remark = "one-of-several" | "adds-little" | "earlier-work" | PhotoRemark["id"];
type Notice = {
  kind: "error" | "remark";
  code: string;
  words: () => { title: string; hint: string };
  retry?: (() => void) | undefined;
};
type Owner = "page" | "studio" | "gpu";

/** One notice per owner; the most recent one is shown. */
const notices = new Map<Owner, Notice>();
/** Whether the browser saves the work. */
let savesWork = true;

/** Writes notices in each locale and makes them closable. */
export function setUpNotice() {
  for (const id of ["notice-retry", "notice-close"]) byId(id, HTMLButtonElement).addEventListener("click", dismissNotices);
  addEventListener("keydown", ({ key }) => key === "Escape" && dismissNotices());
  for (const change of ["toggle", "close"]) {
    addEventListener(change, ({ target }) => target instanceof HTMLDialogElement && write(), { capture: true });
  }
  onLocaleChange(write);
}

/**
 * Shows an error and what to do next.
 *
 * @param retry called when the user asks for it, or dismisses the notice
 */
export function showError(thrown: unknown, owner: Owner = "page", retry?: () => void) {
  show({ ...noticeOf(thrown), retry }, owner);
}

/**
 * Shows information that is not an error.
 *
 * @param values placeholders of the text
 */
export function showRemark(remark: Remark, values: Record<string, string | number>) {
  const words = () => ({ title: t(`remark.${remark}`, values), hint: t(`remark.${remark}.hint`, values) });
  show({ kind: "remark", code: remark, words });
}

/**
 * Reports why a photo was not added, and what to do next.
 *
 * @param name file name
 */
export function showNotAdded(name: string, thrown: unknown) {
  const notice = noticeOf(thrown);
  const words = () => {
    const { title: reason, hint: usual } = notice.words();
    // The general hint asks the user to face the camera, which is wrong for a side view.
    const hint = notice.code === "no-face-found" ? t("photos.not-added.no-face") : usual;
    return { title: t("photos.not-added", { name }), hint: t("photos.not-added.why", { reason, hint }) };
  };
  show({ ...notice, words });
}

/** Hides an owner's notice. */
export function hideNotice(owner: Owner) {
  notices.delete(owner);
  write();
}

/** Hides all notices, and tries again what can be. */
export function dismissNotices() {
  const dismissed = [...notices.values()];
  notices.clear();
  write();
  for (const { retry } of dismissed) retry?.();
}

/** Sets whether hints may say that the work is saved. */
export function setSavesWork(saves: boolean) {
  savesWork = saves;
  write();
}

function show(notice: Notice, owner: Owner = "page") {
  // Makes it the most recent one.
  notices.delete(owner);
  notices.set(owner, notice);
  write();
}

/** Logs unexpected errors to the console. */
function noticeOf(thrown: unknown): Notice {
  const { code } = asPageError(thrown);
  if (code === "other" || !isWord(`error.${code}`)) console.error(thrown);
  return { kind: "error", code, words: () => errorText(code) };
}

/** Translated text of an error; messages of the modules are English and for developers. */
function errorText(code: string) {
  const key = `error.${code}`;
  const known = isWord(key) ? key : "error.other";
  const hints = [savesWork ? "" : `${known}.hint.unkept`, `${known}.hint`];
  return { title: t(known), hint: t(hints.find(isWord) ?? "error.other.hint") };
}

function write() {
  const notice = byId("notice", HTMLDivElement);
  const shown = [...notices.values()].at(-1);
  notice.hidden = !shown;
  place(notice);
  if (!shown) return;
  const { title, hint } = shown.words();
  Object.assign(notice.dataset, { kind: shown.kind, code: shown.code });
  byId("notice-retry", HTMLButtonElement).hidden = !shown.retry;
  byId("notice-title", HTMLParagraphElement).textContent = title;
  byId("notice-hint", HTMLParagraphElement).textContent = hint;
}

/** Moves the notice into an open modal dialog, because elements outside it are inert. */
function place(notice: HTMLElement) {
  const dialog = [...document.querySelectorAll("dialog:modal")].at(-1);
  if (dialog && !notice.hidden) {
    if (notice.parentElement === dialog) return;
    dialog.append(notice);
    notice.popover = "manual";
    notice.showPopover();
  } else if (notice.popover) {
    notice.popover = null;
    byId("not-started", HTMLDivElement).before(notice);
  }
}
