/**
 * Whether this browser can share files of a type. Some browsers check the name.
 *
 * @param type MIME
 */
export function canSend(type: string, name: string = "file") {
  return navigator.canShare?.({ files: [new File([], name, { type })] }) ?? false;
}

/**
 * Opens the share sheet. Resolves to false if the user activation has expired, so that the caller can offer a download.
 */
export async function send(file: File) {
  try {
    await navigator.share({ files: [file] });
    return true;
  } catch (error) {
    const { name } = (error as DOMException);
    // The user closed the share sheet.
    if (name === "AbortError") return true;
    if (name === "NotAllowedError") return false;
    throw error;
  }
}
