/**
 * All bytes of a file, which may be gone by now, or not for this page to read.
 *
 * @param {Blob} file
 */
export async function bytesOf(file) {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}
