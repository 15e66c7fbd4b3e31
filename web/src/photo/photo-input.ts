import { byId, isTyping, onAction } from "../page/dom.ts";
import { showError, showRemark } from "../page/notice.ts";

/** Names and media types of files that the page can open. */
const SUPPORTED = /\.(jpe?g|png|webp|avif|glb|rosto)$|^(image\/(jpeg|png|webp|avif)|model\/gltf-binary)$/i;

/** Sets up the file chooser, drag and drop, and paste. */
export function setUpPhotoInput(open: (photo: Blob) => void) {
  setUpChooser(open);
  setUpDrop(open);
  setUpPaste(open);
}

function setUpChooser(open: (photo: Blob) => void) {
  const input = byId("photo-file", HTMLInputElement);
  const zone = byId("drop-zone", HTMLDivElement);
  const choose = () => input.click();
  input.addEventListener("change", () => {
    const files = [...(input.files ?? [])];
    // Without a reset, choosing the same file again would not fire a change event.
    input.value = "";
    openBest(files, open);
  });
  onAction("choose", choose);
  zone.addEventListener("click", choose);
  zone.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose();
  });
}

function setUpDrop(open: (photo: Blob) => void) {
  const veil = byId("drop-veil", HTMLDivElement);
  addEventListener("dragover", (event) => {
    if (isTextForField(event, event.dataTransfer)) return;
    event.preventDefault();
    veil.hidden = false;
  });
  addEventListener("dragleave", ({ relatedTarget }) => {
    if (relatedTarget === null) veil.hidden = true;
  });
  addEventListener("drop", (event) => {
    veil.hidden = true;
    openTransfer(event, event.dataTransfer, open);
  });
}

function setUpPaste(open: (photo: Blob) => void) {
  let isKeyDown = false;
  const onKey = ({ type, key, shiftKey, ctrlKey, metaKey }: KeyboardEvent) => {
    const isPaste = shiftKey && key === "Insert" || (ctrlKey || metaKey) && key.toLowerCase() === "v";
    isKeyDown = type === "keydown" && isPaste;
  };
  addEventListener("keydown", onKey);
  addEventListener("keyup", onKey);
  addEventListener("paste", (event) => {
    // A middle click pastes the selected text on Linux.
    if (isKeyDown || event.clipboardData?.types.includes("Files")) openTransfer(event, event.clipboardData, open);
  });
  // The middle button turns the face.
  for (const press of ["mousedown", "auxclick"] as const) {
    byId("stage", HTMLElement).addEventListener(press, (event) => event.button === 1 && event.preventDefault());
  }
}

/** Whether text is dropped or pasted into a text field. */
function isTextForField(event: Event, transfer: DataTransfer | null) {
  return isTyping(event) && !transfer?.types.includes("Files");
}

/** Opens a dropped or pasted file, or shows why it can't be opened. */
function openTransfer(event: Event, transfer: DataTransfer | null, open: (photo: Blob) => void) {
  if (!transfer || isTextForField(event, transfer)) return;
  event.preventDefault();
  const items = [...transfer.items].filter((item) => item.kind === "file");
  const files = items.filter((item) => !item.webkitGetAsEntry()?.isDirectory).map((item) => item.getAsFile());
  const readable = files.filter((file) => file !== null);
  if (readable.length > 0) openBest(readable, open);
  else if (items.length > 0) showError({ code: "folder", message: "only folders", hint: "" });
  else if (transfer.types.length > 0) showError({ code: "not-a-file", message: transfer.types.join(), hint: "" });
}

/** Opens the first supported file, else the first picture, and shows a remark if there were other files. */
function openBest(files: File[], open: (photo: Blob) => void) {
  const isSupported = ({ name, type }: File) => SUPPORTED.test(type) || SUPPORTED.test(name);
  const best = files.find(isSupported) ?? files.find(({ type }) => type.startsWith("image/")) ?? files[0];
  if (!best) return;
  open(best);
  // After open(), which dismisses earlier notices.
  if (files.length > 1) showRemark("one-of-several", { n: files.length, name: best.name });
}
