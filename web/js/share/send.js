/**
 * Whether this browser hands pictures on to other programs.
 *
 * @param {string} type MIME
 */
export function canSend(type) {
  return navigator.canShare?.({ files: [new File([], "file", { type })] }) ?? false;
}

/**
 * Offers a file to the visitor's other programs. False where the browser takes the press for too long ago: the file is then
 * to be had in another way.
 *
 * @param {File} file
 */
export async function send(file) {
  try {
    await navigator.share({ files: [file] });
    return true;
  } catch (error) {
    const { name } = /** @type {DOMException} */ (error);
    // Whoever closes the list of programs has changed their mind.
    if (name === "AbortError") return true;
    if (name === "NotAllowedError") return false;
    throw error;
  }
}
