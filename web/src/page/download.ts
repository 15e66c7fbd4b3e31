/**
 * Downloads a file.
 *
 * @param type MIME
 */
export function download(content: Uint8Array | string | Blob, name: string, type: string) {
  const url = URL.createObjectURL(new Blob([(content as BlobPart)], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the blob after this task.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
