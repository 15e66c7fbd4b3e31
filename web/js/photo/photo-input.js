import { byId, isTyping, onAction } from "../page/dom.js";
import { showError, showRemark } from "../page/notice.js";

/** What the page can open, by name; a type alone would let other pictures go first. */
const OPENS = /\.(jpe?g|png|webp|avif|glb|rosto)$/i;
const OPENS_TYPE = /^(image\/(jpeg|png|webp|avif)|model\/gltf-binary)$/;
const PICTURE = /^image\//;

/**
 * Every way in which a photo comes to the page: dropped anywhere, pasted, chosen, or the sample.
 *
 * @param {(photo: Blob) => void} open
 */
export function setUpPhotoInput(open) {
  setUpChooser(open);
  setUpDrop(open);
  setUpPaste(open);
}

/** @param {(photo: Blob) => void} open */
function setUpChooser(open) {
  const input = byId("photo-file", HTMLInputElement);
  const zone = byId("drop-zone", HTMLDivElement);
  const choose = () => input.click();
  input.addEventListener("change", () => {
    const files = [...(input.files ?? [])];
    // The same file can be chosen twice in a row only from an empty input.
    input.value = "";
    openBest(files, open);
  });
  zone.addEventListener("click", choose);
  zone.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose();
  });
  onAction("choose", choose);
}

/** @param {(photo: Blob) => void} open */
function setUpDrop(open) {
  const veil = byId("drop-veil", HTMLDivElement);
  addEventListener("dragover", (event) => {
    if (isTextForField(event, event.dataTransfer)) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  addEventListener("drop", (event) => {
    veil.hidden = true;
    if (isTextForField(event, event.dataTransfer)) return;
    event.preventDefault();
    if (event.dataTransfer) take(event.dataTransfer, open);
  });
}

/** @param {(photo: Blob) => void} open */
function setUpPaste(open) {
  addEventListener("paste", (event) => {
    if (!event.clipboardData || isTextForField(event, event.clipboardData)) return;
    event.preventDefault();
    take(event.clipboardData, open);
  });
}

/**
 * Whether it is text on its way into a field that takes text.
 *
 * @param {Event} event
 * @param {DataTransfer | null} transfer
 */
function isTextForField(event, transfer) {
  return isTyping(event.target) && !transfer?.types.includes("Files");
}

/**
 * Opens what was dropped or pasted, or says why it cannot.
 *
 * @param {DataTransfer} transfer
 * @param {(photo: Blob) => void} open
 */
function take(transfer, open) {
  const items = [...transfer.items].filter((item) => item.kind === "file");
  const files = items.filter((item) => !item.webkitGetAsEntry()?.isDirectory).map((item) => item.getAsFile());
  const there = files.filter((file) => file !== null);
  if (there.length > 0) openBest(there, open);
  else if (items.length > 0) showError({ code: "folder", message: "only folders", hint: "" });
  else if (transfer.types.length > 0) showError({ code: "not-a-file", message: transfer.types.join(), hint: "" });
}

/**
 * Opens the first file that looks like what the page opens, and says so if there were others.
 *
 * @param {File[]} files
 * @param {(photo: Blob) => void} open
 */
function openBest(files, open) {
  const best = files.find(opensHere) ?? files.find(({ type }) => PICTURE.test(type)) ?? files[0];
  if (!best) return;
  open(best);
  // Opening has taken away what the page said before.
  if (files.length > 1) showRemark("one-of-several", { n: files.length, name: best.name });
}

/** @param {File} file */
function opensHere({ name, type }) {
  return OPENS_TYPE.test(type) || OPENS.test(name);
}
