import { byId, onAction } from "../page/dom.js";

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
    const file = input.files?.[0];
    // The same file can be chosen twice in a row only from an empty input.
    input.value = "";
    if (file) open(file);
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
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  addEventListener("drop", (event) => {
    event.preventDefault();
    veil.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (file) open(file);
  });
}

/** @param {(photo: Blob) => void} open */
function setUpPaste(open) {
  addEventListener("paste", (event) => {
    const file = event.clipboardData?.files[0];
    if (!file) return;
    event.preventDefault();
    open(file);
  });
}
