/** Reads photos and saved files for the module. */

import { checkFile, checkSize, sniffedBytes } from "../../wasm/rosto-vision-web.js";
import { asPageError } from "../page/page-error.ts";
import { filesWith } from "../work/face.ts";
import type { Vision } from "../../wasm/rosto-vision-web.js";
import type { SourceFile } from "../work/face.ts";

type Decode<T> = (bytes: Uint8Array, original?: Uint8Array) => T;

/** Reads a file; throws `{code: "unreadable-file", …}` if it was deleted or may not be read. */
export async function bytesOf(file: Blob) {
  try {
    return new Uint8Array(await file.arrayBuffer());
  } catch (error) {
    throw { code: "unreadable-file", message: String(error), hint: "" };
  }
}

/** Reads a file, if it is not too large. */
export async function readFile(file: Blob) {
  const isSaved = checkFile(await bytesOf(file.slice(0, sniffedBytes())), file.size);
  return { bytes: await bytesOf(file), isSaved };
}

/**
 * Decodes a file. Falls back to the browser's decoder for formats that the module does not read.
 *
 * @param bytes of the file
 * @param decode `original`: the file, if the browser decoded it
 */
export async function decoded<T>(file: Blob, bytes: Uint8Array, decode: Decode<T>) {
  try {
    return decode(bytes);
  } catch (error) {
    const converted = asPageError(error).code === "unsupported-format" ? await convertedByBrowser(file) : undefined;
    if (!converted) throw error;
    return decode(await bytesOf(converted), bytes);
  }
}

/** Decodes pictures that the module does not hold: it keeps only the latest, and a restarted worker has none. */
export async function keepPictures(vision: Vision, pictures: string[], files: SourceFile[]) {
  if (pictures.every((picture) => vision.has(picture))) return;
  // All, because keeping one file may drop the pictures of another.
  for (const { key, file } of filesWith(files, pictures)) {
    const { bytes } = await readFile(file);
    await decoded(file, bytes, (readable, original) => vision.keep(key, readable, original));
  }
}

/** The photo as an upright sRGB PNG; undefined if the browser cannot decode it. */
async function convertedByBrowser(photo: Blob) {
  const bitmap = await createImageBitmap(photo).catch(() => undefined);
  if (!bitmap) return undefined;
  const { width, height } = bitmap;
  try {
    checkSize(width, height);
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d", { colorSpace: "srgb" })?.drawImage(bitmap, 0, 0);
    return await canvas.convertToBlob({ type: "image/png" }).catch(() => undefined);
  } finally {
    bitmap.close();
  }
}
