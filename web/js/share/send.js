/**
 * Whether this browser can share files of a type. Some browsers check the name.
 *
 * @param {string} type MIME
 * @param {string} [name]
 */
export function canSend(type, name = "file") {
  return navigator.canShare?.({ files: [new File([], name, { type })] }) ?? false;
}

/**
 * Opens the share sheet. Resolves to false if the user activation has expired, so that the caller can offer a download.
 *
 * @param {File} file
 */
export async function send(file) {
  try {
    await navigator.share({ files: [file] });
    return true;
  } catch (error) {
    const { name } = /** @type {DOMException} */ (error);
    // The user closed the share sheet.
    if (name === "AbortError") return true;
    if (name === "NotAllowedError") return false;
    throw error;
  }
}
