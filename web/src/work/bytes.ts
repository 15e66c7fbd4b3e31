/** Reads a file; throws `{code: "unreadable-file", …}` if it was deleted or may not be read. */
export async function bytesOf(file: Blob) {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}
