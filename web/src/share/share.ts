import { download } from "../page/download.ts";
import { toast } from "../page/toast.ts";
import { t } from "../words/words.ts";

const PNG = "image/png";

/** Saves a file to the downloads. */
export function save(file: File) {
  download(file, file.name, file.type);
  toast(t("export.done", { file: file.name }));
}

/**
 * Whether this browser can share files of a type.
 *
 * @param type MIME
 * @param name some browsers check the extension
 */
export function canShare(type: string, name: string) {
  try {
    return "share" in navigator && navigator.canShare({ files: [new File([], name, { type })] });
  } catch {
    return false;
  }
}

/** Opens the share sheet. Saves the file if the browser refuses, for example because the click was too long ago. */
export async function share(file: File) {
  try {
    await navigator.share({ files: [file] });
  } catch (error) {
    // The user has closed the sheet.
    if (!(error instanceof DOMException && error.name === "AbortError")) save(file);
  }
}

/** Whether this browser can copy pictures to the clipboard. */
export function canCopyPictures() {
  if (typeof ClipboardItem !== "function" || !navigator.clipboard?.write) return false;
  return ClipboardItem.supports?.(PNG) ?? true;
}

/** Copies a picture to the clipboard. Takes a promise, because Safari requires the call during the click. */
export async function copyPicture(picture: Promise<Blob>) {
  try {
    await navigator.clipboard.write([new ClipboardItem({ [PNG]: picture })]);
  } catch (error) {
    // Rethrows the picture's own error, if there is one.
    await picture;
    throw { code: "not-copied", message: String(error), hint: "" };
  }
}
