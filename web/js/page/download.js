/**
 * Downloads a file.
 *
 * @param {Uint8Array | string | Blob} content
 * @param {string} name
 * @param {string} type MIME
 */
export function download(content, name, type) {
  const url = URL.createObjectURL(new Blob([/** @type {BlobPart} */ (content)], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the blob after this task.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
