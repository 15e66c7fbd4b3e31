import { byId, isTyping, onAction } from "../page/dom.ts";
import { showError, showRemark } from "../page/notice.ts";

/** Names and media types of pictures that the page can open. */
const PICTURE = /\.(jpe?g|png|webp|avif)$|^image\/(jpeg|png|webp|avif)$/i;
/** Names and media types of saved faces. */
const SAVED = /\.(glb|rosto)$|^model\/gltf-binary$/i;

export interface Ways {
  open: (file: File) => void;
  /** asks how to open several photos */
  ask: (photos: File[]) => void;
}

/** Sets up the file chooser, drag and drop, and paste. */
export function setUpPhotoInput(ways: Ways) {
  setUpChooser(ways);
  setUpDrop(ways);
  setUpPaste(ways);
}

function setUpChooser(ways: Ways) {
  const input = byId("photo-file", HTMLInputElement);
  const zone = byId("drop-zone", HTMLDivElement);
  const choose = () => input.click();
  input.addEventListener("change", () => {
    const files = [...(input.files ?? [])];
    // Without a reset, choosing the same file again would not fire a change event.
    input.value = "";
    openBest(files, ways);
  });
  onAction("choose", choose);
  zone.addEventListener("click", choose);
  zone.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    choose();
  });
}

function setUpDrop(ways: Ways) {
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
    openTransfer(event, event.dataTransfer, ways);
  });
}

function setUpPaste(ways: Ways) {
  let isKeyDown = false;
  const onKey = ({ type, key, shiftKey, ctrlKey, metaKey }: KeyboardEvent) => {
    const isPaste = shiftKey && key === "Insert" || (ctrlKey || metaKey) && key.toLowerCase() === "v";
    isKeyDown = type === "keydown" && isPaste;
  };
  addEventListener("keydown", onKey);
  addEventListener("keyup", onKey);
  addEventListener("paste", (event) => {
    // A middle click pastes the selected text on Linux.
    if (isKeyDown || event.clipboardData?.types.includes("Files")) openTransfer(event, event.clipboardData, ways);
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

/** Opens dropped or pasted files, or shows why they can't be opened. */
function openTransfer(event: Event, transfer: DataTransfer | null, ways: Ways) {
  if (!transfer || isTextForField(event, transfer)) return;
  event.preventDefault();
  const items = [...transfer.items].filter((item) => item.kind === "file");
  const files = items.filter((item) => !item.webkitGetAsEntry()?.isDirectory).map((item) => item.getAsFile());
  const readable = files.filter((file) => file !== null);
  if (readable.length > 0) openBest(readable, ways);
  else if (items.length > 0) showError({ code: "folder", message: "only folders", hint: "" });
  else if (transfer.types.length > 0) showError({ code: "not-a-file", message: transfer.types.join(), hint: "" });
}

/**
 * Asks how to open several photos. Otherwise, opens the first supported file, else the first picture, and shows a remark
 * if there were other files.
 */
function openBest(files: File[], { open, ask }: Ways) {
  const isA = (kind: RegExp) => ({ name, type }: File) => kind.test(type) || kind.test(name);
  const photos = files.filter(isA(PICTURE));
  const supported = files.find((file) => isA(PICTURE)(file) || isA(SAVED)(file));
  if (photos.length > 1 && supported === photos[0]) return ask(photos);
  const best = supported ?? files.find(({ type }) => type.startsWith("image/")) ?? files[0];
  if (!best) return;
  open(best);
  // After open(), which dismisses earlier notices.
  if (files.length > 1) showRemark("one-of-several", { n: files.length, name: best.name });
}
