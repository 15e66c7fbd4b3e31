/**
 * Whether this browser hands such files on to other programs. Some go by the name.
 *
 * @param {string} type MIME
 * @param {string} [name]
 */
export function canSend(type, name = "file") {
  return navigator.canShare?.({ files: [new File([], name, { type })] }) ?? false;
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
