import { inEveryLanguage, isWord, say } from "../words/words.js";
import { byId } from "./dom.js";

/** @typedef {import("../worker/protocol.js").Trouble} Trouble */

/** @type {Trouble | undefined} */
let shown;
let aboutPhoto = false;

/** Shows notices in the page's language and lets them be closed. */
export function setUpNotice() {
  byId("notice-close", HTMLButtonElement).addEventListener("click", () => hideNotice());
  addEventListener("keydown", ({ key }) => {
    if (key === "Escape") hideNotice();
  });
  inEveryLanguage(write);
}

/**
 * Says what happened, why if known, and what to do next.
 *
 * @param {unknown} thrown
 */
export function showTrouble(thrown) {
  shown = asTrouble(thrown);
  aboutPhoto = false;
  write();
}

/**
 * Says so beside the drop zone as well.
 *
 * @param {unknown} thrown
 */
export function showPhotoTrouble(thrown) {
  shown = asTrouble(thrown);
  aboutPhoto = true;
  write();
}

/** Takes the notice away. */
export function hideNotice() {
  shown = undefined;
  write();
}

/**
 * @param {unknown} thrown
 * @returns {Trouble}
 */
export function asTrouble(thrown) {
  if (typeof thrown === "object" && thrown !== null && "code" in thrown && "message" in thrown) {
    const hint = "hint" in thrown ? String(thrown.hint) : "";
    return { code: String(thrown.code), message: String(thrown.message), hint };
  }
  return { code: "other", message: String(thrown), hint: "" };
}

function write() {
  const notice = byId("notice", HTMLDivElement);
  const photoError = byId("photo-error", HTMLParagraphElement);
  notice.hidden = shown === undefined;
  photoError.hidden = !shown || !aboutPhoto;
  if (!shown) return;
  const { title, hint } = words(shown);
  notice.dataset["code"] = shown.code;
  byId("notice-title", HTMLParagraphElement).textContent = title;
  byId("notice-hint", HTMLParagraphElement).textContent = hint;
  photoError.textContent = `${title}. ${hint}`;
}

/** @param {Trouble} trouble */
function words(trouble) {
  const code = `error.${trouble.code}`;
  const hintCode = `${code}.hint`;
  const title = isWord(code) ? say(code) : say("error.other");
  const hint = isWord(hintCode) ? say(hintCode) : trouble.hint || say("error.other.hint");
  return { title, hint };
}
